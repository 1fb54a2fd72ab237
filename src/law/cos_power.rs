//! Real exponents: the Phong lobe.

use super::Spatial;
use super::exponent::{ExponentError, admitted};
use super::formulas::{Formulas, Own, Phases, pdf_solid_angle, variance};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::moment::cosine_integrals;
use crate::arithmetic::native::pair::Pair;
use crate::arithmetic::native::power::ln;
use crate::law::support::{
    spatial_direction_power, spatial_direction_tails, spatial_power, spatial_tails,
};
use crate::number::Real;
use crate::{CosSin, Moments, Tails};
use core::fmt;
use rand_core::Rng;

/// The spatial law of any real exponent k ≥ 0: the Phong lobe.
///
#[doc = include_str!("../../docs/measured/lobes/cos-power.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Spatial`](crate::Spatial).
///
/// > (k+1) cosᵏθ / (2π) per steradian; q = that times sin θ per dθ dφ, θ ∈ \[0, π/2\]
///
/// with cdf 1 − cosᵏ⁺¹θ. k = 0 is the uniform hemisphere, k = 1, 2, 3 are
/// [`Lambert`](crate::Lambert), [`SphereShell`](crate::SphereShell) and [`Ball`](crate::Ball),
/// whose own types need no logarithm. Every finite k is accepted: cosᵏθ is formed from log₂ cos θ
/// with extra digits, so that a large k does not magnify the error. What depends on k alone is
/// worked out once, by [`new`](CosPower::new).
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
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct CosPower<T: Real> {
    exponent: T,
    #[cfg_attr(feature = "serde", serde(skip))]
    lobe: Lobe<T::Quick>,
}

impl<T: Real> PartialEq for CosPower<T> {
    fn eq(&self, other: &Self) -> bool {
        self.exponent == other.exponent
    }
}

impl<T: Real> fmt::Debug for CosPower<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("CosPower")
            .field("exponent", &self.exponent)
            .finish()
    }
}

#[cfg(feature = "defmt")]
impl<T: Real + defmt::Format> defmt::Format for CosPower<T> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "CosPower {{ exponent: {} }}", self.exponent);
    }
}

impl<T: Real> CosPower<T> {
    /// The law ∝ cosᵏθ; −0 is 0.
    ///
    /// # Errors
    /// If `k` is NaN, negative or infinite.
    pub fn new(k: T) -> Result<Self, ExponentError> {
        let exponent = admitted(k)?;
        let lobe = Lobe::new(Holds::from_number(exponent));
        Ok(CosPower { exponent, lobe })
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

/// The law in a working arithmetic, with the constants of its exponent.
#[derive(Clone, Copy)]
pub struct Lobe<W: Kernel> {
    k: W::Wide,
    /// k + 1, exactly.
    next: W::Wide,
    /// (k+1)/2π.
    scale: W::Scale,
    ln_scale: W::Wide,
    /// 1 − k, exactly, and 2/(k+1).
    weight_power: W::Wide,
    weight_scale: W::Scale,
    root: W::TailRoot,
}

impl<W: Kernel> Lobe<W> {
    #[inline]
    fn new(k: W) -> Self {
        let next = W::Wide::two_sum(k, W::ONE);
        Lobe {
            k: W::Wide::from_value(k),
            next,
            scale: W::scale(next.mul(W::CONSTANTS.recip_two_pi)),
            ln_scale: W::ln_wide(next).add(W::CONSTANTS.ln_two_pi.neg()),
            weight_power: W::Wide::two_sum(W::ONE, -k),
            weight_scale: W::two_over(next),
            root: W::tail_root(next),
        }
    }

    /// (k+1) cosᵏθ/(2π).
    #[inline(always)]
    fn per_steradian(&self, at: W::Cosine) -> W {
        W::power_times(self.k, at, self.scale, W::ONE)
    }

    #[inline(always)]
    fn tails_at(&self, at: W::Cosine) -> Tails<W> {
        let (lower, upper) = W::power_tails(self.next, at);
        Tails::from_both(lower, upper)
    }
}

impl<W: Kernel> Formulas<W> for Lobe<W> {
    #[inline(always)]
    fn pdf(&self, theta: W) -> W {
        let (at, sin) = W::cosine_at_angle(theta);
        let p = W::power_times(self.k, at, self.scale, sin);
        spatial_power(theta, p, W::ZERO)
    }

    /// Between −1 and 1 the error is bounded in ulps of 1, not of the result: its terms cancel
    /// where the density passes 1.
    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        let (at, _) = W::cosine_at_angle(theta);
        let p = W::ln_power_times_sine(self.k, at, self.ln_scale);
        spatial_power(theta, p, -W::INFINITY)
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let (at, _) = W::cosine_at_angle(theta);
        spatial_tails(theta, self.tails_at(at))
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        spatial_direction_power(at, self.per_steradian(W::cosine(at)))
    }

    /// cos θ = (1 − u)^(1/(k+1)).
    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        W::power_warp(p, self.root)
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        spatial_direction_tails(at, self.tails_at(W::cosine(at)))
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        let weight = W::power_times(self.weight_power, W::cosine(at), self.weight_scale, W::ONE);
        spatial_direction_power(at, weight)
    }

    #[inline(always)]
    fn density_at(&self, theta: W) -> W {
        let (at, _) = W::cosine_at_angle(theta);
        spatial_power(theta, self.per_steradian(at), W::ZERO)
    }
}

impl<T: Real> Own for CosPower<T> {}

impl<T: Real> Phases<T> for CosPower<T> {
    type Quick = Lobe<T::Quick>;
    type Accurate = Lobe<T::Accurate>;

    #[inline(always)]
    fn quick(&self) -> Lobe<T::Quick> {
        self.lobe
    }

    #[inline(always)]
    fn accurate(&self) -> Lobe<T::Accurate> {
        Lobe::new(Holds::from_number(self.exponent))
    }

    fn moments(&self) -> Moments<T> {
        moments(self.exponent.to_base()).map(T::from_base)
    }
}

fn moments<B: Native>(k: B) -> Moments<B> {
    let plus = |n| Pair::two_sum(k, B::int(n));
    let next = plus(1);
    let mean_cos = next.div(plus(2));
    // θ² is of the size of 1/k, which for a large k is subnormal.
    let large = k * B::DROP * B::NEGLIGIBLE * B::NEGLIGIBLE > B::ONE;
    let [down, root_down] = if large {
        [B::DROP, B::ROOT_DROP]
    } else {
        [B::ONE, B::ONE]
    };
    let scaled = Pair {
        hi: next.hi * down,
        lo: next.lo * down,
    };
    let (mean_theta, weighted) = cosine_integrals(scaled);
    let twice = weighted.add(weighted);
    let entropy = <B as Native>::CONSTANTS
        .ln_two_pi
        .add(ln(next).neg())
        .add(Pair::from_value(k).div(next));
    Moments {
        mean_cos: mean_cos.value(),
        var_cos: mean_cos.div(plus(3)).div(plus(2)).value(),
        mean_theta: mean_theta.value() * root_down,
        var_theta: variance(twice, mean_theta).value() * down,
        entropy: entropy.value(),
    }
}

impl<T: Real> Spatial<T> for CosPower<T> {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        pdf_solid_angle(self, theta)
    }
}
