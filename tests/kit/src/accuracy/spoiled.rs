//! Planted errors that the sweeps must notice.

use super::format::Format;
use coslobe::{CircleShell, CosSin, Disk, Law, Moments, Tails};

/// A law with one operation spoiled: the tests above must notice each.
#[derive(Clone, Copy)]
pub enum Spoiled {
    /// cos θ of an `f32` angle against `f32`'s π/2: the digits beside the horizon are gone.
    NaiveCosine,
    /// The upper tail as 1 − u.
    OneMinus,
    /// Kepler's residual y − sin y by subtraction.
    NaiveResidual,
    /// Six last places off in one window in a thousand.
    Nudged,
}

impl<T: Format> Law<T> for Spoiled {
    fn pdf(&self, theta: T) -> T {
        match self {
            Spoiled::NaiveCosine => {
                let c = T::of(T::of(std::f64::consts::FRAC_PI_2).wide() - theta.wide())
                    .wide()
                    .sin();
                T::of(c * c * std::f64::consts::FRAC_2_PI)
            }
            Spoiled::Nudged if (1.0..1.001).contains(&theta.wide()) => {
                T::of_bits(Disk.pdf(theta).bits() + 6)
            }
            _ => Disk.pdf(theta),
        }
    }
    fn tails(&self, theta: T) -> Tails<T> {
        match self {
            Spoiled::OneMinus => Tails::from_lower(Law::<T>::cdf(&Disk, theta)),
            Spoiled::NaiveResidual => {
                let y = 2.0 * (std::f64::consts::FRAC_PI_2 - theta.wide().abs());
                Tails::from_upper(T::of((y - y.sin()) / std::f64::consts::TAU))
            }
            _ => Disk.tails(theta),
        }
    }
    fn ln_pdf(&self, theta: T) -> T {
        Disk.ln_pdf(theta)
    }
    fn density(&self, at: CosSin<T>) -> T {
        Disk.density(at)
    }
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        Disk.warp_tails(p)
    }
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        Disk.unwarp_tails(at)
    }
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        Disk.lambert_weight(at)
    }
    fn moments(&self) -> Moments<T> {
        Disk.moments()
    }
}

/// `CircleShell` with its direction at an upper tail, or its density at an angle, passed through a
/// function.
pub struct Altered<W, P> {
    pub warp: W,
    pub pdf: P,
}

impl<W, P> Law<f32> for Altered<W, P>
where
    W: Fn(f32, CosSin<f32>) -> CosSin<f32>,
    P: Fn(f32, f32) -> f32,
{
    fn pdf(&self, theta: f32) -> f32 {
        (self.pdf)(theta, CircleShell.pdf(theta))
    }
    fn warp_sf(&self, p: f32) -> CosSin<f32> {
        (self.warp)(p, CircleShell.warp_sf(p))
    }
    fn tails(&self, theta: f32) -> Tails<f32> {
        CircleShell.tails(theta)
    }
    fn ln_pdf(&self, theta: f32) -> f32 {
        CircleShell.ln_pdf(theta)
    }
    fn density(&self, at: CosSin<f32>) -> f32 {
        CircleShell.density(at)
    }
    fn warp_tails(&self, p: Tails<f32>) -> CosSin<f32> {
        CircleShell.warp_tails(p)
    }
    fn unwarp_tails(&self, at: CosSin<f32>) -> Tails<f32> {
        CircleShell.unwarp_tails(at)
    }
    fn lambert_weight(&self, at: CosSin<f32>) -> f32 {
        CircleShell.lambert_weight(at)
    }
    fn moments(&self) -> Moments<f32> {
        CircleShell.moments()
    }
}
