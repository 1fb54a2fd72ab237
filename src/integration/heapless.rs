//! `heapless`: fills a vector of fixed capacity, without an allocator.

#[cfg(feature = "fixed")]
use crate::integers::{Format, Formulas, Integers};
use crate::{Planar, Real, Spatial};
use heapless::Vec;
use rand_core::Rng;

/// Draws directions \[sin θ, cos θ\] until `out` is full and returns how many were added; what it
/// already holds stays. Randomness: [`Planar::sample`] for each, in order.
///
/// ```
/// use coslobe::{Disk, integration::heapless::fill_planar};
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let mut rays = heapless::Vec::<[f32; 2], 8>::new();
/// assert_eq!(fill_planar(&Disk, &mut rng, &mut rays), 8);
/// assert_eq!(fill_planar(&Disk, &mut rng, &mut rays), 0);
/// ```
pub fn fill_planar<T, L, R, const CAP: usize>(
    law: &L,
    rng: &mut R,
    out: &mut Vec<[T; 2], CAP>,
) -> usize
where
    T: Real,
    L: Planar<T>,
    R: Rng + ?Sized,
{
    let before = out.len();
    // Not extend, which links a panic.
    while !out.is_full() && out.push(law.sample(rng)).is_ok() {}
    out.len() - before
}

/// Draws directions \[sin θ cos φ, cos θ, sin θ sin φ\] until `out` is full and returns how many
/// were added; what it already holds stays. Randomness: [`Spatial::sample`] for each, in order.
///
/// ```
/// use coslobe::{Lambert, integration::heapless::fill_spatial};
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let mut rays = heapless::Vec::<[f32; 3], 64>::new();
/// fill_spatial(&Lambert, &mut rng, &mut rays);
/// assert!(rays.iter().all(|ray| ray[1] > 0.0));
/// ```
pub fn fill_spatial<T, L, R, const CAP: usize>(
    law: &L,
    rng: &mut R,
    out: &mut Vec<[T; 3], CAP>,
) -> usize
where
    T: Real,
    L: Spatial<T>,
    R: Rng + ?Sized,
{
    let before = out.len();
    // Not extend, which links a panic.
    while !out.is_full() && out.push(law.sample(rng)).is_ok() {}
    out.len() - before
}

/// Draws directions of a law in integers until `out` is full and returns how many were added; what
/// it already holds stays. Randomness: `sample` for each, in order.
///
/// ```
/// use coslobe::{Fixed16, Lambert, integration::heapless::fill_fixed};
/// use fixed::types::I1F15;
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let mut rays = heapless::Vec::<[I1F15; 3], 64>::new();
/// fill_fixed(&Fixed16(Lambert), &mut rng, &mut rays);
/// assert!(rays.iter().all(|ray| ray[1] > 0));
/// ```
#[cfg(feature = "fixed")]
pub fn fill_fixed<F, L, R, const CAP: usize>(
    law: &Integers<F, L>,
    rng: &mut R,
    out: &mut Vec<L::Direction, CAP>,
) -> usize
where
    F: Format,
    L: Formulas<F>,
    R: Rng + ?Sized,
{
    let before = out.len();
    // Not extend, which links a panic.
    while !out.is_full() && out.push(law.sample(rng)).is_ok() {}
    out.len() - before
}
