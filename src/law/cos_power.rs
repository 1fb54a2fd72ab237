//! Real exponents: the Phong lobe.

use super::{Law, Spatial};
use crate::kernel::moment::cosine_integrals;
use crate::kernel::pair::Pair;
use crate::kernel::power::{exp_times, ln, ln_cos_power, one_minus_exp};
use crate::kernel::select::{spatial, spatial_pair, spatial_pair_tails, spatial_tails, within};
use crate::kernel::trig::{PairCosSin, at_angle_fine};
use crate::number::Real;
use crate::{CosSin, Moments, Tails};
use core::fmt;
use rand_core::Rng;

/// The spatial law of any real exponent k ≥ 0: the Phong lobe.
///
/// > (k+1) cosᵏθ / (2π) per steradian; q = that times sin θ per dθ dφ, θ ∈ \[0, π/2\]
///
/// with cdf 1 − cosᵏ⁺¹θ. k = 0 is the uniform hemisphere, k = 1, 2, 3 are
/// [`Lambert`](crate::Lambert), [`SphereShell`](crate::SphereShell) and [`Ball`](crate::Ball), whose
/// own types need no logarithm. Every finite k is accepted: cosᵏθ is formed from ln cos θ with extra
/// digits, so that a large k does not magnify the error.
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` and one `next_u32` for `f32`, three
/// `next_u64` for `f64`.
///
/// ```
/// use coslobe::{CosPower, Law, Spatial};
/// let lobe = CosPower::new(64.0f32)?;
/// assert!((lobe.pdf_solid_angle(0.0) - 65.0 / core::f32::consts::TAU).abs() < 1e-5);
/// assert!(CosPower::new(-1.0f32).is_err());
/// # Ok::<(), coslobe::ExponentError>(())
/// ```
///
/// Source: B. T. Phong, 1975, DOI 10.1145/360825.360839.
#[doc(alias = "Phong")]
#[doc(alias = "cosine lobe")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CosPower<T> {
    exponent: T,
}

/// Why an exponent was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ExponentError {
    /// The exponent is NaN.
    NotANumber,
    /// The exponent is negative.
    Negative,
    /// The exponent is infinite.
    Infinite,
}

impl fmt::Display for ExponentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ExponentError::NotANumber => "the exponent is NaN; expected a finite number ≥ 0",
            ExponentError::Negative => "the exponent is negative; expected a finite number ≥ 0",
            ExponentError::Infinite => "the exponent is infinite; expected a finite number ≥ 0",
        })
    }
}

impl core::error::Error for ExponentError {}

impl<T: Real> CosPower<T> {
    /// The law ∝ cosᵏθ; −0 is 0.
    ///
    /// # Errors
    /// If `k` is NaN, negative or infinite.
    pub fn new(k: T) -> Result<Self, ExponentError> {
        if k.is_nan() {
            Err(ExponentError::NotANumber)
        } else if k < T::ZERO {
            Err(ExponentError::Negative)
        } else if !k.is_finite() {
            Err(ExponentError::Infinite)
        } else {
            Ok(CosPower { exponent: k.abs() })
        }
    }

    /// The exponent k.
    #[inline]
    pub fn exponent(&self) -> T {
        self.exponent
    }

    /// [`Spatial::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }

    /// k + 1, exactly.
    #[inline(always)]
    fn successor(&self) -> Pair<T> {
        Pair::sum(self.exponent, T::ONE)
    }

    /// (k+1) cosᵏθ/(2π) times `factor`.
    #[inline]
    fn lobe(&self, at: PairCosSin<T>, factor: Pair<T>) -> T {
        let scale = self.successor().times(T::TABLE.recip_two_pi).times(factor);
        if at.cos.hi > T::ZERO {
            exp_times(ln_cos_power(Pair::exact(self.exponent), at), scale)
        } else if self.exponent == T::ZERO {
            scale.value()
        } else {
            T::ZERO
        }
    }

    #[inline]
    fn tails_at(&self, at: PairCosSin<T>) -> Tails<T> {
        if at.cos.hi > T::ZERO {
            let a = ln_cos_power(self.successor(), at);
            Tails::from_both(one_minus_exp(a), exp_times(a, Pair::exact(T::ONE)))
        } else {
            Tails::from_nearer(T::ZERO, true)
        }
    }
}

#[inline(always)]
fn exact<T: Real>(at: CosSin<T>) -> PairCosSin<T> {
    PairCosSin {
        cos: Pair::exact(at.cos),
        sin: Pair::exact(at.sin),
    }
}

impl<T: Real> Law<T> for CosPower<T> {
    #[inline]
    fn pdf(&self, theta: T) -> T {
        let at = at_angle_fine(theta);
        within(theta, spatial(theta), self.lobe(at, at.sin), T::ZERO)
    }

    /// Summed in pairs, since its terms cancel where the density passes 1 (large k only); between −1
    /// and 1 the error is bounded in ulps of 1, not of the result.
    #[inline]
    fn ln_pdf(&self, theta: T) -> T {
        let at = at_angle_fine(theta);
        let power = ln_cos_power(Pair::exact(self.exponent), at);
        let p = if at.sin.hi > T::ZERO && power.hi.is_finite() {
            ln(self.successor())
                .add(T::TABLE.ln_two_pi.neg())
                .add(power)
                .add(ln(at.sin))
                .value()
        } else {
            -T::INFINITY
        };
        within(theta, spatial(theta), p, -T::INFINITY)
    }

    #[inline]
    fn tails(&self, theta: T) -> Tails<T> {
        spatial_tails(theta, self.tails_at(at_angle_fine(theta)))
    }

    #[inline]
    fn density(&self, at: CosSin<T>) -> T {
        spatial_pair(at, self.lobe(exact(at), Pair::exact(T::ONE)))
    }

    /// cos θ = (1 − u)^(1/(k+1)), through the exponential of a pair.
    #[inline]
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        let (lower, upper) = (p.lower(), p.upper());
        if upper == T::ZERO {
            return CosSin {
                cos: T::ZERO,
                sin: T::ONE,
            };
        }
        let log = if upper < T::HALF {
            ln(Pair::exact(upper))
        } else {
            Pair::exact((-lower).ln_1p())
        };
        let next = self.successor();
        let a = log.div(next);
        let twice = a.add(a);
        let sin = if -a.hi < T::NEGLIGIBLE * T::NEGLIGIBLE {
            // sin²θ = −2a, which for large k underflows before its root does.
            (-(log.hi + log.hi)).sqrt() / next.hi.sqrt()
        } else {
            one_minus_exp(twice).sqrt()
        };
        CosSin {
            cos: exp_times(a, Pair::exact(T::ONE)),
            sin,
        }
    }

    #[inline]
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        spatial_pair_tails(at, self.tails_at(exact(at)))
    }

    #[inline]
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        let k = Pair::sum(self.exponent, -T::ONE);
        let scale = Pair::exact(T::int(2)).div(self.successor());
        let weight = if at.cos > T::ZERO {
            exp_times(ln_cos_power(k.neg(), exact(at)), scale)
        } else if self.exponent == T::ONE {
            T::ONE
        } else if self.exponent > T::ONE {
            T::INFINITY
        } else {
            T::ZERO
        };
        spatial_pair(at, weight)
    }

    fn moments(&self) -> Moments<T> {
        let k = self.exponent;
        let next = self.successor();
        let mean_cos = next.hi / (k + T::int(2));
        let (mean_theta, weighted) = cosine_integrals(next.hi);
        let entropy = T::TABLE
            .ln_two_pi
            .add(ln(next).neg())
            .add(Pair::exact(k).div(next));
        Moments {
            mean_cos,
            var_cos: mean_cos / (k + T::int(3)) / (k + T::int(2)),
            mean_theta,
            var_theta: weighted + weighted - mean_theta * mean_theta,
            entropy: entropy.value(),
        }
    }
}

impl<T: Real> Spatial<T> for CosPower<T> {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        let p = self.lobe(at_angle_fine(theta), Pair::exact(T::ONE));
        within(theta, spatial(theta), p, T::ZERO)
    }
}
