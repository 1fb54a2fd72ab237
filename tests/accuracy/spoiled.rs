//! Planted errors that the sweeps must notice.

use super::format::Format;
use coslobe::{CosSin, Disk, Law, Moments, Tails};

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
                let c = T::round(T::round(std::f64::consts::FRAC_PI_2).wide() - theta.wide())
                    .wide()
                    .sin();
                T::round(c * c * std::f64::consts::FRAC_2_PI)
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
                Tails::from_upper(T::round((y - y.sin()) / std::f64::consts::TAU))
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
