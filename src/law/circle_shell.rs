//! Uniform by radial thickness on a circle: the paper's circle, and the flat world's Lambert law.

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

/// Direction of a point of a **radial shell** on a circle tangent to the origin (paper 3.2,
/// "circle").
///
#[doc = include_str!("../../docs/measured/lobes/circle-shell.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Planar`](crate::Planar); the point itself:
/// [`PlanarPoint`](crate::PlanarPoint).
///
/// The shell has constant thickness along the ray, not across the curve: the paper's measure is
/// δ(r − 2ρ cos θ) r dr dθ, whose mass 4ρ gives the density
///
/// > p(θ) = cos θ / 2 per radian, θ ∈ \[−π/2, π/2\]
///
/// and cdf (1 + sin θ)/2. Points uniform by arc length follow [`CircleArc`](crate::CircleArc)
/// instead: the arc element has another factor √(r² + r′²)/r = 1/cos θ, which cancels the cosine.
/// cos θ / 2 is a real law all the same, Lambert's and Knudsen's in a flat world.
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` for `f32`, two for `f64`.
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
///
/// ```
/// use coslobe::{CircleShell, Law};
/// let at = CircleShell.warp(0.75f32);
/// assert_eq!(at.sin, 0.5);
/// assert_eq!(CircleShell.pdf(0.0f64), 0.5);
/// ```
///
/// Source: V. Chizhov, *Probability density functions of the normalized disk, circle, ball and
/// sphere*, section 3.2.
#[doc(alias = "circle")]
#[doc(alias = "normalized circle")]
#[doc(alias = "Knudsen")]
#[doc(alias = "flat Lambert")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CircleShell;

impl CircleShell {
    /// [`Planar::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<T: Real, R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(self, rng)
    }
}

impl<W: Kernel> Formulas<W> for CircleShell {
    #[inline(always)]
    fn pdf(&self, theta: W) -> W {
        let p = W::at_angle(theta).cos.value() * W::HALF;
        within(theta, planar(theta), p, W::ZERO)
    }

    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        let p = W::ln_cos(W::at_angle(theta)) - W::CONSTANTS.ln_2.value();
        within(theta, planar(theta), p, -W::INFINITY)
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let at = W::at_angle(theta);
        let p = nearer_tail(at.cos.times(at.cos).value(), at.sin.value());
        let p = within(theta, planar(theta), p, W::ZERO);
        Tails::from_nearer(p, theta > W::ZERO)
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        planar_direction(at, at.cos * W::HALF)
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        let (p, is_lower) = p.nearer();
        let sin = W::ONE - (p + p);
        // 4p(1 − p), each half in the order that keeps it monotone in p.
        let (from_end, from_axis) = ((p - p * p) * W::int(4), W::ONE - sin * sin);
        let cos_squared = if p < W::QUARTER { from_end } else { from_axis };
        CosSin {
            cos: cos_squared.sqrt(),
            sin: sin.negate_if_odd(is_lower),
        }
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let sin = at.sin.abs();
        let p = if at.cos <= sin {
            nearer_tail(at.cos * at.cos, sin)
        } else {
            (W::ONE - sin) * W::HALF
        };
        Tails::from_nearer(planar_direction(at, p), at.sin > W::ZERO)
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        planar_direction(at, W::ONE)
    }
}

impl Own for CircleShell {}

impl Parameterless for CircleShell {
    fn moments<B: Native>() -> Moments<Pair<B>> {
        let c = <B as Native>::CONSTANTS;
        let mean_cos = c.half_pi.half();
        Moments {
            mean_cos,
            var_cos: variance(Pair::ratio(2, 3), mean_cos),
            mean_theta: Pair::from_value(B::ZERO),
            var_theta: c.half_pi.mul(c.half_pi).add(Pair::ratio(-2, 1)),
            entropy: Pair::from_value(B::ONE),
        }
    }
}

impl Point for CircleShell {
    const MEASURE: Measure = Measure::CircleShell;
    const IS_PLANAR: bool = true;

    /// cos θ / 2.
    #[inline]
    fn point_density<W: Kernel>(_: W, at: CosSin<W>) -> W {
        at.cos * W::HALF
    }

    #[inline]
    fn ln_point_density<W: Kernel>(_: W, at: CosSin<W>) -> W {
        at.cos.ln() - W::CONSTANTS.ln_2.value()
    }
}

/// With p the nearer tail, |sin θ| = 1 − 2p and cos²θ = 2p (1 + |sin θ|): all digits in the fewest
/// operations, which count where each is a routine.
impl<T: Real> Planar<T> for CircleShell {
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
    let double = p + p;
    let sin = W::ONE - double;
    [sin.negate_if(!is_upper), (double + double * sin).sqrt()]
}

/// (1 − |sin θ|)/2 without its cancellation near the horizon.
#[inline(always)]
fn nearer_tail<W: Kernel>(cos_squared: W, sin: W) -> W {
    cos_squared * W::HALF / (W::ONE + sin)
}
