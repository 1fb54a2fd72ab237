//! Uniform by radial thickness on a circle: the paper's circle, and the flat world's Lambert law.

use super::{Law, Planar};
use crate::kernel::select::{planar, planar_pair, within};
use crate::kernel::trig::at_angle;
use crate::number::Real;
use crate::{CosSin, Measure, Moments, Tails, Tangent};
use rand_core::Rng;

/// Direction of a point of a **radial shell** on a circle tangent to the origin (paper 3.2, "circle").
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

impl<T: Real> Law<T> for CircleShell {
    #[inline]
    fn pdf(&self, theta: T) -> T {
        let p = at_angle(theta).cos.value() * T::HALF;
        within(theta, planar(theta), p, T::ZERO)
    }

    #[inline]
    fn ln_pdf(&self, theta: T) -> T {
        let p = at_angle(theta).ln_cos() - T::TABLE.ln_2.hi;
        within(theta, planar(theta), p, -T::INFINITY)
    }

    #[inline]
    fn tails(&self, theta: T) -> Tails<T> {
        let at = at_angle(theta);
        let p = nearer_tail(at.cos.times(at.cos).value(), at.sin.value());
        let p = within(theta, planar(theta), p, T::ZERO);
        Tails::from_nearer(p, theta > T::ZERO)
    }

    #[inline]
    fn density(&self, at: CosSin<T>) -> T {
        planar_pair(at, at.cos * T::HALF)
    }

    #[inline]
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        let (p, is_upper) = p.nearer();
        let sin = T::ONE - (p + p);
        // 4p(1 − p), each half in the order that keeps it monotone in p.
        let cos_squared = if p < T::QUARTER {
            (p - p * p) * T::int(4)
        } else {
            T::ONE - sin * sin
        };
        CosSin {
            cos: cos_squared.sqrt(),
            sin: sin.negate_if(!is_upper),
        }
    }

    #[inline]
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        let sin = at.sin.abs();
        let p = if at.cos <= sin {
            nearer_tail(at.cos * at.cos, sin)
        } else {
            (T::ONE - sin) * T::HALF
        };
        Tails::from_nearer(planar_pair(at, p), at.sin > T::ZERO)
    }

    #[inline]
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        planar_pair(at, T::ONE)
    }

    #[inline]
    fn moments(&self) -> Moments<T> {
        T::TABLE.circle_shell_moments
    }
}

impl<T: Real> Tangent<T> for CircleShell {
    const MEASURE: Measure = Measure::CircleShell;
}

impl<T: Real> Planar<T> for CircleShell {}

/// (1 − |sin θ|)/2 without its cancellation near the horizon.
#[inline(always)]
fn nearer_tail<T: Real>(cos_squared: T, sin: T) -> T {
    cos_squared * T::HALF / (T::ONE + sin)
}
