//! Uniform by radial thickness on a sphere: the paper's sphere.

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

/// Direction of a point of a **radial shell** on a sphere tangent to the origin (paper 4.2,
/// "sphere").
///
#[doc = include_str!("../../docs/measured/lobes/sphere-shell.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Spatial`](crate::Spatial); the point itself:
/// [`SpatialPoint`](crate::SpatialPoint).
///
/// The shell has constant thickness along the ray, not across the surface: the paper's measure is
/// δ(r − 2ρ cos θ) r² sin θ dr dθ dφ, whose mass 8πρ²/3 gives the density
///
/// > 3 cos²θ / (2π) per steradian; q = 3 cos²θ sin θ / (2π) per dθ dφ, θ ∈ \[0, π/2\]
///
/// and cdf 1 − cos³θ. Points uniform on the surface follow [`Lambert`](crate::Lambert)'s law
/// instead: the surface element has another factor √(r² + r′²)/r = 1/cos θ. Mean cos θ is ¾ here,
/// ⅔ there.
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` and one `next_u32` for `f32`, three
/// `next_u64` for `f64`.
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
///
/// ```
/// use coslobe::{Law, SphereShell};
/// let at = SphereShell.warp_sf(0.125f32);
/// assert_eq!(at.cos, 0.5);
/// ```
///
/// Source: V. Chizhov, *Probability density functions of the normalized disk, circle, ball and
/// sphere*, section 4.2.
#[doc(alias = "sphere")]
#[doc(alias = "normalized sphere")]
#[doc(alias = "cosine squared")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphereShell;

impl SphereShell {
    /// [`Spatial::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<T: Real, R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

impl<W: Kernel> Formulas<W> for SphereShell {
    #[inline(always)]
    fn pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        let p = at.cos.times(at.sin).times(at.cos);
        within(
            theta,
            spatial(theta),
            p.times(W::CONSTANTS.three_over_two_pi).value(),
            W::ZERO,
        )
    }

    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        let p = at.cos.times(at.cos).times(W::CONSTANTS.three_over_two_pi);
        let p = p.value().ln() + at.sin.value().ln();
        within(theta, spatial(theta), p, -W::INFINITY)
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let at = W::at_angle(theta);
        let (c2, s2) = (at.cos.times(at.cos), at.sin.times(at.sin));
        let lower = lower_tail(at.cos.value(), s2.value());
        spatial_tails(theta, Tails::from_both(lower, c2.times(at.cos).value()))
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        let p = at.cos * at.cos * W::CONSTANTS.three_over_two_pi.value();
        spatial_direction(at, p)
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        W::cube_warp(p)
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let CosSin { cos: c2, sin: s2 } = at.squares();
        let lower = lower_tail(at.cos, s2);
        spatial_direction_tails(at, Tails::from_both(lower, c2 * at.cos.abs()))
    }

    /// With sin θ rounded from pairs: one rounding of a monotone value is monotone.
    #[inline(always)]
    fn quantile_tails(&self, p: Tails<W>) -> W {
        let Some(wide) = W::cbrt_wide(p) else {
            return W::angle(self.warp_tails(p));
        };
        let one = W::Wide::from_value(W::ONE);
        let next = one.add(wide);
        let square = next.div(next.add(wide.mul(wide)));
        let sin = square.mul(W::Wide::from_value(p.lower())).sqrt();
        let cos = p.upper().cbrt();
        W::angle(CosSin { cos, sin })
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        spatial_direction(at, W::int(2) / (W::int(3) * at.cos.abs()))
    }

    #[inline(always)]
    fn density_at(&self, theta: W) -> W {
        let c = W::at_angle(theta).cos;
        let p = c.times(c).times(W::CONSTANTS.three_over_two_pi).value();
        within(theta, spatial(theta), p, W::ZERO)
    }
}

impl Own for SphereShell {}

impl Parameterless for SphereShell {
    fn moments<B: Native>() -> Moments<Pair<B>> {
        let c = <B as Native>::CONSTANTS;
        let mean_cos = Pair::ratio(3, 4);
        let mean_theta = Pair::ratio(2, 3);
        let mean_theta_squared = c.two_pi.mul(Pair::ratio(1, 3)).add(Pair::ratio(-14, 9));
        Moments {
            mean_cos,
            var_cos: variance(Pair::ratio(3, 5), mean_cos),
            mean_theta,
            var_theta: variance(mean_theta_squared, mean_theta),
            entropy: Pair::ratio(2, 3).add(c.ln_three_over_two_pi.neg()),
        }
    }
}

impl Point for SphereShell {
    const MEASURE: Measure = Measure::SphereShell;
    const IS_PLANAR: bool = false;

    /// 3 cos²θ sin θ / 2π.
    #[inline]
    fn point_density<W: Kernel>(_: W, at: CosSin<W>) -> W {
        at.cos * at.cos * W::CONSTANTS.three_over_two_pi.value() * at.sin
    }

    #[inline]
    fn ln_point_density<W: Kernel>(_: W, at: CosSin<W>) -> W {
        W::CONSTANTS.ln_three_over_two_pi.value() + at.cos.ln() * W::int(2) + at.sin.ln()
    }
}

/// 1 − cos³θ = sin²θ (1 + cos θ + cos²θ)/(1 + cos θ), without its cancellation near the axis.
#[inline(always)]
fn lower_tail<W: Kernel>(cos: W, sin_squared: W) -> W {
    sin_squared * (W::ONE + cos + cos * cos) / (W::ONE + cos)
}

/// cos²θ = max(u, v²) of two uniforms: it is below c² where u < c² and v < c, which has the
/// probability c³, so that no cube root is taken. The rest is as with
/// [`Lambert`](crate::Lambert), whose cos²θ is u.
impl<T: Real> Spatial<T> for SphereShell {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        pdf_solid_angle(self, theta)
    }

    #[inline(always)]
    fn try_draw_theta<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<TailBits<T>, R::Error> {
        T::try_draw_pair_bits(rng)
    }

    /// Of which the upper one is max(u, v²).
    #[inline(always)]
    fn drawn_tails(&self, theta: TailBits<T>, code: Code) -> Tails<T> {
        let (u, v) = theta.split();
        uniform::upper_tails::<T>(u.max(<TailBits<T> as Bits>::square(v)), code)
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
