//! Uniform by arc length on a circle.

use super::Planar;
use super::formulas::{Formulas, Own, Parameterless, variance};
use super::measure::{Measure, Point};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::law::support::{planar, planar_direction, within};
use crate::number::Real;
use crate::number::tier::{Code, Margin};
use crate::uniform::TailBits;
use crate::{CosSin, Moments, Tails};
use rand_core::Rng;

/// Direction of a point uniform **by arc length** on a circle tangent to the origin.
///
#[doc = include_str!("../../docs/measured/lobes/circle-arc.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Planar`](crate::Planar); the point itself:
/// [`PlanarPoint`](crate::PlanarPoint).
///
/// By the inscribed-angle theorem equal arcs are seen from a point of the circle under equal
/// angles:
///
/// > p(θ) = 1/π per radian, θ ∈ \[−π/2, π/2\]
///
/// with cdf ½ + θ/π. This is what "uniform on the circle" gives; the paper's section 3.2 measures a
/// radial shell instead and finds cos θ / 2, see [`CircleShell`](crate::CircleShell).
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` for `f32`, two for `f64`.
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
///
/// ```
/// use coslobe::{CircleArc, Law};
/// let at = CircleArc.warp(1e-20f64); // 1e-20 of a half turn from −90°
/// assert!((at.cos / (std::f64::consts::PI * 1e-20) - 1.0).abs() < 1e-15);
/// ```
///
/// Source: Euclid, *Elements* III.21; the measure that section 3.2 of the paper describes.
#[doc(alias = "uniform angle")]
#[doc(alias = "inscribed angle")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CircleArc;

impl CircleArc {
    /// [`Planar::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<T: Real, R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(self, rng)
    }
}

impl<W: Kernel> Formulas<W> for CircleArc {
    #[inline(always)]
    fn pdf(&self, theta: W) -> W {
        within(theta, planar(theta), W::CONSTANTS.recip_pi.value(), W::ZERO)
    }

    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        within(
            theta,
            planar(theta),
            -W::CONSTANTS.ln_pi.value(),
            -W::INFINITY,
        )
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let p = W::from_end(theta.abs())
            .times(W::CONSTANTS.recip_pi)
            .value();
        let p = within(theta, planar(theta), p, W::ZERO);
        Tails::from_nearer(p, theta > W::ZERO)
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        planar_direction(at, W::CONSTANTS.recip_pi.value())
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        let (p, is_lower) = p.nearer();
        let CosSin { cos, sin } = W::half_turn(p);
        CosSin {
            cos,
            sin: sin.negate_if_odd(is_lower),
        }
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let (sin, recip_pi) = (at.sin.abs(), W::CONSTANTS.recip_pi.value());
        let p = if at.cos <= sin {
            at.cos.atan2(sin) * recip_pi
        } else {
            W::HALF - sin.atan2(at.cos) * recip_pi
        };
        Tails::from_nearer(planar_direction(at, p), at.sin > W::ZERO)
    }

    #[inline(always)]
    fn quantile_tails(&self, p: Tails<W>) -> W {
        let (p, is_lower) = p.nearer();
        let d = W::HALF - p;
        let theta = W::Wide::from_value(d).times(W::CONSTANTS.pi).value();
        theta.negate_if_odd(is_lower)
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        planar_direction(at, W::CONSTANTS.half_pi.value() * at.cos)
    }
}

impl Own for CircleArc {}

impl Parameterless for CircleArc {
    fn moments<B: Native>() -> Moments<Pair<B>> {
        let c = <B as Native>::CONSTANTS;
        let mean_cos = c.two_over_pi;
        Moments {
            mean_cos,
            var_cos: variance(Pair::ratio(1, 2), mean_cos),
            mean_theta: Pair::from_value(B::ZERO),
            var_theta: c.pi.mul(c.pi).mul(Pair::ratio(1, 12)),
            entropy: c.ln_pi,
        }
    }
}

impl Point for CircleArc {
    const MEASURE: Measure = Measure::ArcLength;
    const IS_PLANAR: bool = true;

    /// 1/(2πρ).
    #[inline]
    fn point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        let recip_pi = W::CONSTANTS.recip_pi.value();
        recip_pi * W::HALF / rho
    }

    #[inline]
    fn ln_point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        -(W::CONSTANTS.ln_two_pi.value() + rho.ln())
    }
}

/// Of the nearer tail alone.
impl<T: Real> Planar<T> for CircleArc {
    #[inline(always)]
    fn sample_by(&self, bits: TailBits<T>, code: Code) -> [T; 2] {
        let (p, is_upper) = T::nearer_from_bits(bits, code);
        T::rounded(
            Margin::Relative,
            #[inline(always)]
            || at_nearer(Holds::from_number(p), is_upper),
            #[inline(always)]
            || at_nearer(Holds::from_number(p), is_upper),
        )
    }
}

/// [sin θ, cos θ] at the nearer tail.
#[inline(always)]
fn at_nearer<W: Kernel>(p: W, is_upper: bool) -> [W; 2] {
    let CosSin { cos, sin } = W::half_turn(p);
    [sin.negate_if(!is_upper), cos]
}
