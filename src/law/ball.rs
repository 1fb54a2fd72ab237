//! Uniform by volume in a ball.

use super::Spatial;
use super::direction::{Azimuth, angle_at_square, at_square};
use super::formulas::{Formulas, Own, Parameterless, pdf_solid_angle, variance};
use super::measure::{Measure, Point};
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::law::support::{
    spatial, spatial_direction, spatial_direction_tails, spatial_tails, within,
};
use crate::number::Real;
use crate::number::tier::{Bits, Code};
use crate::uniform::{TailBits, TurnBits};
use crate::{CosSin, Moments, Tails, uniform};
use rand_core::{Rng, TryRng};

/// Direction of a point uniform **by volume** in a ball tangent to the origin (paper 4.1).
///
#[doc = include_str!("../../docs/measured/lobes/ball.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Spatial`](crate::Spatial); the point itself:
/// [`SpatialPoint`](crate::SpatialPoint).
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
    #[inline(always)]
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

    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        // One logarithm for cos³θ: three times that of cos θ has three times its error.
        let c = at.cos;
        let p = c.times(c).times(c.times(W::CONSTANTS.two_over_pi));
        let p = p.value().ln() + at.sin.value().ln();
        within(theta, spatial(theta), p, -W::INFINITY)
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let at = W::at_angle(theta);
        let (c2, s2) = (at.cos.times(at.cos), at.sin.times(at.sin));
        let lower = s2.value() * (W::ONE + c2.value());
        spatial_tails(theta, Tails::from_both(lower, c2.times(c2).value()))
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        let p = at.cos * at.cos * at.cos * W::CONSTANTS.two_over_pi.value();
        spatial_direction(at, p)
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        W::fourth_power_warp(p)
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let CosSin { cos: c2, sin: s2 } = at.squares();
        let lower = s2 * (W::ONE + c2);
        spatial_direction_tails(at, Tails::from_both(lower, c2 * c2))
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        // Scaled, since cos²θ alone can be subnormal where the weight is finite.
        let four_cos = at.cos * W::int(4);
        spatial_direction(at, W::int(8) / (four_cos * four_cos))
    }

    #[inline(always)]
    fn density_at(&self, theta: W) -> W {
        let c = W::at_angle(theta).cos;
        let p = c.times(c).times(c.times(W::CONSTANTS.two_over_pi)).value();
        within(theta, spatial(theta), p, W::ZERO)
    }
}

impl Own for Ball {}

impl Parameterless for Ball {
    fn moments<B: Native>() -> Moments<Pair<B>> {
        let c = <B as Native>::CONSTANTS;
        let mean_cos = Pair::ratio(4, 5);
        let mean_theta = c.pi.mul(Pair::ratio(3, 16));
        let mean_theta_squared =
            c.pi.mul(c.pi)
                .mul(Pair::ratio(3, 32))
                .add(Pair::ratio(-1, 2));
        Moments {
            mean_cos,
            var_cos: variance(Pair::ratio(2, 3), mean_cos),
            mean_theta,
            var_theta: variance(mean_theta_squared, mean_theta),
            entropy: Pair::ratio(3, 4).add(c.ln_two_over_pi.neg()),
        }
    }
}

impl Point for Ball {
    const MEASURE: Measure = Measure::Volume;
    const IS_PLANAR: bool = false;
    const IS_SOLID: bool = true;

    #[inline]
    fn share<W: Kernel>(v: W) -> W {
        v.cbrt()
    }

    /// 3/(4πρ³).
    #[inline]
    fn point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        let recip = W::ONE / rho;
        W::CONSTANTS.three_over_two_pi.value() * W::HALF / rho * recip * recip
    }

    #[inline]
    fn ln_point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        let ln_two_cubes = W::CONSTANTS.ln_2.value() + rho.ln() * W::int(3);
        W::CONSTANTS.ln_three_over_two_pi.value() - ln_two_cubes
    }
}

/// cos²θ = max(u, v) of two uniforms: it is below c² where both are, which has the probability c⁴,
/// so that one root is taken for the cosine and no quotient for the sine. The rest is
/// as with [`Lambert`](crate::Lambert), whose cos²θ is u.
impl<T: Real> Spatial<T> for Ball {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        pdf_solid_angle(self, theta)
    }

    #[inline(always)]
    fn try_draw_theta<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<TailBits<T>, R::Error> {
        T::try_draw_pair_bits(rng)
    }

    /// Of which the upper one is max(u, v).
    #[inline(always)]
    fn drawn_tails(&self, theta: TailBits<T>, code: Code) -> Tails<T> {
        let (u, v) = theta.split();
        uniform::upper_tails::<T>(u.max(v), code)
    }

    #[inline(always)]
    fn drawn_angle(&self, p: Tails<T>) -> CosSin<T> {
        angle_at_square(p)
    }

    #[inline(always)]
    fn drawn_direction(&self, p: Tails<T>, phi: TurnBits<T>) -> [T; 3] {
        at_square(p, Azimuth::Word(phi))
    }
}
