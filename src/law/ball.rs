//! Uniform by volume in a ball.

use super::Spatial;
use super::formulas::{Formulas, Own, Parameterless, pdf_solid_angle};
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::law::support::{
    spatial, spatial_direction, spatial_direction_tails, spatial_tails, within,
};
use crate::number::Real;
use crate::{CosSin, Measure, Moments, Tails, Tangent};
use rand_core::Rng;

/// Direction of a point uniform **by volume** in a ball tangent to the origin (paper 4.1).
///
/// A ray at θ from +y leaves the ball of radius ρ about (0, ρ, 0) at r = 2ρ cos θ, so
/// ∫₀^{2ρ cos θ} r² dr / (4πρ³/3) gives the density
///
/// > 2 cos³θ / π per steradian; q = 2 cos³θ sin θ / π per dθ dφ, θ ∈ \[0, π/2\]
///
/// and cdf 1 − cos⁴θ. As a sampler for a Lambert reflector its weight 1/(2 cos²θ) has infinite
/// variance: see [`Law::lambert_weight`](crate::Law::lambert_weight).
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` and one `next_u32` for `f32`, three
/// `next_u64` for `f64`.
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
///
/// ```
/// use coslobe::{Ball, Law};
/// let at = Ball.warp_sf(1e-8f64); // one direction in 10⁸ lies nearer to the horizon
/// assert!((at.cos - 0.01).abs() < 1e-17);
/// ```
///
/// Source: V. Chizhov, *Probability density functions of the normalized disk, circle, ball and
/// sphere*, section 4.1.
#[doc(alias = "normalized ball")]
#[doc(alias = "cosine cubed")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ball;

impl Ball {
    /// [`Spatial::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<T: Real, R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

impl<W: Kernel> Formulas<W> for Ball {
    #[inline]
    fn pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        let p = at.cos.times(at.cos).times(at.cos.times(at.sin));
        within(
            theta,
            spatial(theta),
            p.times(W::CONSTANTS.two_over_pi).value(),
            W::ZERO,
        )
    }

    #[inline]
    fn ln_pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        let p =
            W::CONSTANTS.ln_two_over_pi.value() + W::ln_cos(at) * W::int(3) + at.sin.value().ln();
        within(theta, spatial(theta), p, -W::INFINITY)
    }

    #[inline]
    fn tails(&self, theta: W) -> Tails<W> {
        let at = W::at_angle(theta);
        let (c2, s2) = (at.cos.times(at.cos), at.sin.times(at.sin));
        let lower = s2.value() * (W::ONE + c2.value());
        spatial_tails(theta, Tails::from_both(lower, c2.times(c2).value()))
    }

    #[inline]
    fn density(&self, at: CosSin<W>) -> W {
        let p = at.cos * at.cos * at.cos * W::CONSTANTS.two_over_pi.value();
        spatial_direction(at, p)
    }

    #[inline]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        let (cos, cos_squared) = p.upper().fourth_root();
        CosSin {
            cos,
            sin: W::sqrt_scaled(p.lower(), |x| x / (W::ONE + cos_squared)),
        }
    }

    #[inline]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let CosSin { cos: c2, sin: s2 } = at.squares();
        let lower = s2 * (W::ONE + c2);
        spatial_direction_tails(at, Tails::from_both(lower, c2 * c2))
    }

    #[inline]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        spatial_direction(at, W::HALF / (at.cos * at.cos))
    }

    #[inline]
    fn density_at(&self, theta: W) -> W {
        let c = W::at_angle(theta).cos;
        let p = c.times(c).times(c.times(W::CONSTANTS.two_over_pi)).value();
        within(theta, spatial(theta), p, W::ZERO)
    }
}

impl Own for Ball {}

impl Parameterless for Ball {
    #[inline]
    fn moments<B: Native>() -> Moments<B> {
        B::TABLE.ball_moments
    }
}

impl<T: Real> Tangent<T> for Ball {
    const MEASURE: Measure = Measure::Volume;
}

impl<T: Real> Spatial<T> for Ball {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        pdf_solid_angle(self, theta)
    }
}
