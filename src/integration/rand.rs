//! `rand`: every law is a [`Distribution`] over its directions, with the bits of its `sample`.
//!
//! Each law has an inherent `sample` too, so that a caller with both traits in scope meets no
//! ambiguity. Randomness as [`Planar::sample`] and [`Spatial::sample`].

#[cfg(feature = "fixed")]
use crate::integers::{Format, Formulas, Integers};
use crate::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Lambert, Planar, Real, Spatial, SphereShell,
};
use rand::distr::Distribution;
use rand_core::Rng;

/// Draws \[sin θ, cos θ\]: [`Planar::sample`].
///
/// ```
/// use coslobe::Disk;
/// use rand::RngExt;
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let [sin, cos]: [f32; 2] = rng.sample(Disk);
/// assert!(cos > 0.0 && sin.abs() < 1.0);
/// ```
impl<T: Real> Distribution<[T; 2]> for Disk {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(self, rng)
    }
}

/// Draws \[sin θ, cos θ\]: [`Planar::sample`].
impl<T: Real> Distribution<[T; 2]> for CircleShell {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(self, rng)
    }
}

/// Draws \[sin θ, cos θ\]: [`Planar::sample`].
impl<T: Real> Distribution<[T; 2]> for CircleArc {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(self, rng)
    }
}

/// Draws \[sin θ cos φ, cos θ, sin θ sin φ\]: [`Spatial::sample`].
///
/// ```
/// use coslobe::Ball;
/// use rand::distr::Distribution;
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let rays: Vec<[f32; 3]> = Ball.sample_iter(&mut rng).take(9).collect();
/// assert!(rays.iter().all(|ray| ray[1] > 0.0));
/// ```
impl<T: Real> Distribution<[T; 3]> for Ball {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

/// Draws \[sin θ cos φ, cos θ, sin θ sin φ\]: [`Spatial::sample`].
impl<T: Real> Distribution<[T; 3]> for SphereShell {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

/// Draws \[sin θ cos φ, cos θ, sin θ sin φ\]: [`Spatial::sample`].
impl<T: Real> Distribution<[T; 3]> for Lambert {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

/// Draws \[sin θ cos φ, cos θ, sin θ sin φ\]: [`Spatial::sample`].
impl<T: Real> Distribution<[T; 3]> for CosPower<T> {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

/// Draws what the law's own `sample` draws.
///
/// ```
/// use coslobe::{Fixed, Lambert};
/// use fixed::types::I1F31;
/// use rand::RngExt;
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let ray: [I1F31; 3] = rng.sample(Fixed(Lambert));
/// assert!(ray[1] > 0);
/// ```
#[cfg(feature = "fixed")]
impl<F: Format, L: Formulas<F>> Distribution<L::Direction> for Integers<F, L> {
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        Integers::sample(self, rng)
    }
}
