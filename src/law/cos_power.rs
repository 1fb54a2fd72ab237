//! Real exponents: the Phong lobe.

use super::Spatial;
use super::formulas::{Formulas, Own, Phases, pdf_solid_angle};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::moment::cosine_integrals;
use crate::arithmetic::native::pair::Pair;
use crate::arithmetic::native::power::ln;
use crate::law::support::{
    spatial, spatial_direction, spatial_direction_tails, spatial_tails, within,
};
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
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
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
}

impl<W: Kernel> CosPower<W> {
    /// k + 1, exactly.
    #[inline(always)]
    fn successor(&self) -> W::Wide {
        W::Wide::two_sum(self.exponent, W::ONE)
    }

    /// (k+1) cosᵏθ/(2π) times `factor`.
    #[inline]
    fn lobe(&self, at: CosSin<W::Wide>, factor: W::Wide) -> W {
        let scale = self
            .successor()
            .times(W::CONSTANTS.recip_two_pi)
            .times(factor);
        if at.cos.leading() > W::ZERO {
            W::exp_times(W::ln_cos_power(W::Wide::exact(self.exponent), at), scale)
        } else if self.exponent == W::ZERO {
            scale.value()
        } else {
            W::ZERO
        }
    }

    #[inline]
    fn tails_at(&self, at: CosSin<W::Wide>) -> Tails<W> {
        if at.cos.leading() > W::ZERO {
            let (lower, upper) = W::power_tails(self.successor(), at);
            Tails::from_both(lower, upper)
        } else {
            Tails::from_nearer(W::ZERO, true)
        }
    }
}

#[inline(always)]
fn exact<W: Kernel>(at: CosSin<W>) -> CosSin<W::Wide> {
    CosSin {
        cos: W::Wide::exact(at.cos),
        sin: W::Wide::exact(at.sin),
    }
}

impl<W: Kernel> Formulas<W> for CosPower<W> {
    #[inline]
    fn pdf(&self, theta: W) -> W {
        let at = W::at_angle_fine(theta);
        within(theta, spatial(theta), self.lobe(at, at.sin), W::ZERO)
    }

    /// Summed in pairs, since its terms cancel where the density passes 1 (large k only); between −1
    /// and 1 the error is bounded in ulps of 1, not of the result.
    #[inline]
    fn ln_pdf(&self, theta: W) -> W {
        let at = W::at_angle_fine(theta);
        let power = W::ln_cos_power(W::Wide::exact(self.exponent), at);
        let p = if at.sin.leading() > W::ZERO && power.leading().is_finite() {
            W::ln_wide(self.successor())
                .add(W::CONSTANTS.ln_two_pi.neg())
                .add(power)
                .add(W::ln_wide(at.sin))
                .value()
        } else {
            -W::INFINITY
        };
        within(theta, spatial(theta), p, -W::INFINITY)
    }

    #[inline]
    fn tails(&self, theta: W) -> Tails<W> {
        spatial_tails(theta, self.tails_at(W::at_angle_fine(theta)))
    }

    #[inline]
    fn density(&self, at: CosSin<W>) -> W {
        spatial_direction(at, self.lobe(exact(at), W::Wide::exact(W::ONE)))
    }

    /// cos θ = (1 − u)^(1/(k+1)).
    #[inline]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        W::power_warp(p, self.successor())
    }

    #[inline]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        spatial_direction_tails(at, self.tails_at(exact(at)))
    }

    #[inline]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        let k = W::Wide::two_sum(self.exponent, -W::ONE);
        let scale = W::Wide::exact(W::int(2)).div(self.successor());
        let weight = if at.cos > W::ZERO {
            W::exp_times(W::ln_cos_power(k.neg(), exact(at)), scale)
        } else if self.exponent == W::ONE {
            W::ONE
        } else if self.exponent > W::ONE {
            W::INFINITY
        } else {
            W::ZERO
        };
        spatial_direction(at, weight)
    }

    #[inline]
    fn density_at(&self, theta: W) -> W {
        let p = self.lobe(W::at_angle_fine(theta), W::Wide::exact(W::ONE));
        within(theta, spatial(theta), p, W::ZERO)
    }
}

impl<T> Own for CosPower<T> {}

impl<T: Real> Phases<T> for CosPower<T> {
    type Quick = CosPower<T::Quick>;
    type Accurate = CosPower<T::Accurate>;

    #[inline(always)]
    fn quick(&self) -> CosPower<T::Quick> {
        CosPower {
            exponent: T::Quick::from_number(self.exponent),
        }
    }

    #[inline(always)]
    fn accurate(&self) -> CosPower<T::Accurate> {
        CosPower {
            exponent: T::Accurate::from_number(self.exponent),
        }
    }

    fn moments(&self) -> Moments<T> {
        moments(self.exponent.to_base()).map(T::from_base)
    }
}

fn moments<B: Native>(k: B) -> Moments<B> {
    let next = Pair::two_sum(k, B::ONE);
    let mean_cos = next.hi / (k + B::int(2));
    let (mean_theta, weighted) = cosine_integrals(next.hi);
    let entropy = <B as Native>::CONSTANTS
        .ln_two_pi
        .add(ln(next).neg())
        .add(Pair::exact(k).div(next));
    Moments {
        mean_cos,
        var_cos: mean_cos / (k + B::int(3)) / (k + B::int(2)),
        mean_theta,
        var_theta: weighted + weighted - mean_theta * mean_theta,
        entropy: entropy.value(),
    }
}

impl<T: Real> Spatial<T> for CosPower<T> {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        pdf_solid_angle(self, theta)
    }
}
