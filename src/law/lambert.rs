//! Uniform by area on a sphere: Lambert's cosine law.

use super::Spatial;
use super::formulas::{Formulas, Own, Parameterless, pdf_solid_angle, variance};
use super::measure::{Measure, Point};
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::law::support::{
    spatial, spatial_direction, spatial_direction_tails, spatial_tails, within,
};
use crate::number::Real;
use crate::{CosSin, Moments, Tails};
use rand_core::Rng;

/// Direction of a point uniform **by surface area** on a sphere tangent to the origin: Lambert's
/// law.
///
#[doc = include_str!("../../docs/measured/lobes/lambert.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Spatial`](crate::Spatial); the point itself:
/// [`SpatialPoint`](crate::SpatialPoint).
///
/// The surface element of r = 2ρ cos θ is r √(r² + r′²) sin θ dθ dφ = 4ρ² cos θ sin θ dθ dφ, of
/// 4πρ² in all:
///
/// > cos θ / π per steradian; q = cos θ sin θ / π per dθ dφ, θ ∈ \[0, π/2\]
///
/// with cdf sin²θ. Also exported as [`SphereArea`](crate::SphereArea), the name that says its
/// measure. The paper's section 4.2 sets out to find this law but measures a radial shell, which
/// gives [`SphereShell`](crate::SphereShell). Its weight for a Lambert reflector is 1: zero
/// variance under a constant sky.
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` and one `next_u32` for `f32`, three
/// `next_u64` for `f64`.
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
///
/// ```
/// use coslobe::{Lambert, Law, Spatial, SphereArea};
/// assert_eq!(Lambert.warp(0.25f64).sin, 0.5);
/// assert_eq!(SphereArea.pdf_solid_angle(0.0), std::f64::consts::FRAC_1_PI);
/// ```
///
/// Source: J. H. Lambert, *Photometria*, 1760; the measure that section 4 of the paper describes.
#[doc(alias = "cosine-weighted hemisphere")]
#[doc(alias = "cosine hemisphere")]
#[doc(alias = "uniform sphere surface")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Lambert;

impl Lambert {
    /// [`Spatial::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<T: Real, R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(self, rng)
    }
}

impl<W: Kernel> Formulas<W> for Lambert {
    #[inline(always)]
    fn pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        let p = at.cos.times(at.sin).times(W::CONSTANTS.recip_pi).value();
        within(theta, spatial(theta), p, W::ZERO)
    }

    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        let at = W::at_angle(theta);
        let p = at.cos.times(W::CONSTANTS.recip_pi);
        let p = p.value().ln() + at.sin.value().ln();
        within(theta, spatial(theta), p, -W::INFINITY)
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let at = W::at_angle(theta);
        let (c2, s2) = (at.cos.times(at.cos), at.sin.times(at.sin));
        spatial_tails(theta, Tails::from_both(s2.value(), c2.value()))
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        spatial_direction(at, at.cos * W::CONSTANTS.recip_pi.value())
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        W::square_warp(p)
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let CosSin { cos: c2, sin: s2 } = at.squares();
        spatial_direction_tails(at, Tails::from_both(s2, c2))
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        spatial_direction(at, W::ONE)
    }

    #[inline(always)]
    fn density_at(&self, theta: W) -> W {
        let p = W::at_angle(theta).cos.times(W::CONSTANTS.recip_pi).value();
        within(theta, spatial(theta), p, W::ZERO)
    }
}

impl Own for Lambert {}

impl Parameterless for Lambert {
    fn moments<B: Native>() -> Moments<Pair<B>> {
        let c = <B as Native>::CONSTANTS;
        let mean_cos = Pair::ratio(2, 3);
        let mean_theta = c.half_pi.half();
        let mean_theta_squared = c.half_pi.mul(c.half_pi).half().add(Pair::ratio(-1, 2));
        Moments {
            mean_cos,
            var_cos: variance(Pair::ratio(1, 2), mean_cos),
            mean_theta,
            var_theta: variance(mean_theta_squared, mean_theta),
            entropy: c.ln_pi.add(Pair::ratio(1, 2)),
        }
    }
}

impl Point for Lambert {
    const MEASURE: Measure = Measure::SurfaceArea;
    const IS_PLANAR: bool = false;

    /// 1/(4πρ²).
    #[inline]
    fn point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        let recip_pi = W::CONSTANTS.recip_pi.value();
        recip_pi * W::QUARTER / rho * (W::ONE / rho)
    }

    #[inline]
    fn ln_point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        -(W::CONSTANTS.ln_pi.value() + (W::CONSTANTS.ln_2.value() + rho.ln()) * W::int(2))
    }
}

impl<T: Real> Spatial<T> for Lambert {
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        pdf_solid_angle(self, theta)
    }
}
