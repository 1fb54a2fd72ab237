//! The formulas' arithmetic in `Fast<f32>`.

use super::Fast;
use crate::arithmetic::constants::Constants;
use crate::arithmetic::fast::fixed::at_most_one;
use crate::arithmetic::fast::{angle, kepler, power, root};
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::logarithmic::{self, Logarithmic};
use crate::arithmetic::native::float::Float;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::arithmetic::native::trig;
use crate::arithmetic::native::turn::{into_quadrant, nearest_quarter};
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

#[inline(always)]
pub(crate) fn fast((cos, sin): (f32, f32)) -> CosSin<Fast<f32>> {
    CosSin {
        cos: Fast(cos),
        sin: Fast(sin),
    }
}

/// √f(a) where f would lose digits of a.
#[cold]
fn root_of_subnormal(a: Fast<f32>, f: impl Fn(Fast<f32>) -> Fast<f32>) -> Fast<f32> {
    Scalar::sqrt(f(a * Fast(f32::ROOT_UP))) * Fast(f32::ROOT_DOWN)
}

/// (cos θ, |sin θ|) by `f32`'s kernel: a power multiplies the relative error of the cosine.
#[inline(always)]
fn at_angle_fine(theta: Fast<f32>) -> CosSin<Fast<f32>> {
    let CosSin { cos, sin } = trig::at_angle(theta.0);
    fast((cos.value(), sin.value()))
}

/// c·eᵃ where eᵃ alone would leave the range of the format.
#[cold]
fn far_exp_times(a: f32, c: Fast<f32>) -> Fast<f32> {
    // In quarters: half of −191, which with the largest c still gives a number, is beyond exp.
    let quarter = Fast(power::exp(a * 0.25));
    c * quarter * quarter * quarter * quarter
}

const fn constant(pair: Pair<f32>) -> Fast<f32> {
    Fast(pair.hi)
}

impl Kernel for Fast<f32> {
    type Wide = Self;
    type Cosine = CosSin<Self>;
    type Scale = Self;
    type TailRoot = Self;

    const CONSTANTS: Constants<Self> = {
        let c = <f32 as Native>::CONSTANTS;
        Constants {
            half_pi: constant(c.half_pi),
            two_pi: constant(c.two_pi),
            pi: constant(c.pi),
            recip_pi: constant(c.recip_pi),
            two_over_pi: constant(c.two_over_pi),
            recip_two_pi: constant(c.recip_two_pi),
            twelve_pi: constant(c.twelve_pi),
            three_over_two_pi: constant(c.three_over_two_pi),
            two_over_three_pi: constant(c.two_over_three_pi),
            ln_2: constant(c.ln_2),
            ln_two_pi: constant(c.ln_two_pi),
            ln_pi: constant(c.ln_pi),
            ln_two_over_pi: constant(c.ln_two_over_pi),
            ln_three_over_two_pi: constant(c.ln_three_over_two_pi),
        }
    };

    #[inline(always)]
    fn sqrt_scaled(a: Self, f: impl Fn(Self) -> Self) -> Self {
        let tiny = a.0 < f32::MIN_POSITIVE;
        if root::BY_SELECTS {
            let up = Self::select(tiny, Fast(f32::ROOT_UP), Self::ONE);
            let down = Self::select(tiny, Fast(f32::ROOT_DOWN), Self::ONE);
            Scalar::sqrt(f(a * up)) * down
        } else if tiny {
            root_of_subnormal(a, f)
        } else {
            Scalar::sqrt(f(a))
        }
    }
    #[inline(always)]
    fn cbrt(self) -> Self {
        Fast(root::cbrt(self.0))
    }
    #[inline(always)]
    fn ln(self) -> Self {
        Fast(power::ln(self.0))
    }
    #[inline(always)]
    fn ln_cos(at: CosSin<Self>) -> Self {
        Fast(power::ln_cos(at.cos.0, at.sin.0))
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        Fast(angle::atan2(self.0, x.0))
    }
    #[inline(always)]
    fn angle(at: CosSin<Self>) -> Self {
        Fast(angle::atan2_first(at.sin.0, at.cos.0)).copysign(at.sin)
    }
    #[inline(always)]
    fn from_end(a: Self) -> Self {
        Fast(angle::from_end(a.0))
    }
    #[inline(always)]
    fn at_angle(theta: Self) -> CosSin<Self> {
        fast(angle::sin_cos(theta.0))
    }
    #[inline(always)]
    fn at_quadrant(quadrant: u32, x: Self) -> CosSin<Self> {
        into_quadrant(quadrant, fast(angle::eighth_turn(x.0)))
    }
    #[inline(always)]
    fn at_turn(u: Self) -> CosSin<Self> {
        let (quadrant, x) = nearest_quarter(u.0);
        Self::at_quadrant(quadrant, Fast(x))
    }
    #[inline(always)]
    fn half_turn(p: Self) -> CosSin<Self> {
        fast(angle::half_turn(p.0))
    }
    #[inline(always)]
    fn disk_tail_at_angle(a: Self) -> Self {
        Fast(kepler::tail_at_angle(a.0))
    }
    #[inline(always)]
    fn disk_tail_at_direction(cos: Self, sin: Self) -> Self {
        Fast(kepler::tail_at_direction(cos.0, sin.0))
    }
    #[inline(always)]
    fn disk_direction_at_tail(p: Self) -> CosSin<Self> {
        fast(kepler::direction_at_tail(p.0))
    }
    #[inline(always)]
    fn disk_angle_at_tail(p: Self) -> Self {
        Fast(kepler::angle_at_tail(p.0))
    }
    #[inline(always)]
    fn ln_wide(x: Self) -> Self {
        Kernel::ln(x)
    }
    #[inline(always)]
    fn cosine(at: CosSin<Self>) -> CosSin<Self> {
        at
    }
    #[inline(always)]
    fn cosine_at_angle(theta: Self) -> (CosSin<Self>, Self) {
        let at = at_angle_fine(theta);
        (at, at.sin)
    }
    #[inline(always)]
    fn scale(x: Self) -> Self {
        x
    }
    #[inline(always)]
    fn two_over(x: Self) -> Self {
        Self::int(2) / x
    }
    #[inline(always)]
    fn power_times(k: Self, at: CosSin<Self>, scale: Self, factor: Self) -> Self {
        logarithmic::power_times(k, at, scale * factor)
    }
    #[inline(always)]
    fn ln_power_times_sine(k: Self, at: CosSin<Self>, c: Self) -> Self {
        logarithmic::ln_power_times_sine(k, at, c)
    }
    #[inline(always)]
    fn power_tails(n: Self, at: CosSin<Self>) -> (Self, Self) {
        logarithmic::power_tails(n, at)
    }
    #[inline(always)]
    fn tail_root(n: Self) -> Self {
        n
    }
    #[inline(always)]
    fn power_warp(p: Tails<Self>, n: Self) -> CosSin<Self> {
        let log = Fast(power::ln_upper(p.lower().0, p.upper().0));
        let a = log / n;
        let sin = if -a.0 < 1e-30 {
            // sin²θ = −2a, which for large n underflows before its root does. The logarithm is not
            // positive, and its size has no −0 for a root to keep. A subnormal one lost its last
            // digit.
            let lower = p.lower();
            let size = if lower.0 < f32::MIN_POSITIVE {
                lower
            } else {
                log.abs()
            };
            Scalar::sqrt(size + size) / Scalar::sqrt(n)
        } else {
            Scalar::sqrt(Self::one_minus_exp(a + a))
        };
        CosSin {
            cos: Fast(at_most_one(Self::exp_times(a, Self::ONE).0)),
            sin,
        }
    }
}

impl Logarithmic for Fast<f32> {
    #[inline(always)]
    fn ln_cos_power(k: Self, at: CosSin<Self>) -> Self {
        if at.sin.0 < 1e-15 {
            // −k·sin²θ/2, in an order that does not underflow for a k as large as 1/sin²θ.
            -(k * at.sin * at.sin * Self::HALF)
        } else {
            k * Self::ln_cos(at)
        }
    }
    #[inline(always)]
    fn exp_times(a: Self, c: Self) -> Self {
        if a.0.abs() < 86.0 {
            c * Fast(power::exp(a.0))
        } else {
            far_exp_times(a.0, c)
        }
    }
    #[inline(always)]
    fn one_minus_exp(a: Self) -> Self {
        Fast(power::one_minus_exp(a.0))
    }
}
