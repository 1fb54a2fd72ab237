//! `heapless`: fills a vector of fixed capacity, without an allocator.

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
