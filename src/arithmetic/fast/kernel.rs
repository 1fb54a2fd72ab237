//! The formulas' arithmetic in `Fast<f32>`.

use super::Fast;
use crate::arithmetic::constants::Constants;
use crate::arithmetic::fast::tail_root::TailRoot;
use crate::arithmetic::fast::{angle, kepler, power, root};
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::logarithmic::{self, Logarithmic};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::arithmetic::native::trig;
use crate::scalar::{BY_SELECTS, Scalar};
use crate::{CosSin, Tails};

#[inline(always)]
pub(crate) fn fast((cos, sin): (f32, f32)) -> CosSin<Fast<f32>> {
    CosSin {
        cos: Fast(cos),
        sin: Fast(sin),
    }
}

/// (cos θ, |sin θ|) by `f32`'s kernel: a power multiplies the relative error of the cosine.
#[inline(always)]
fn at_angle_fine(theta: Fast<f32>) -> CosSin<Fast<f32>> {
    let CosSin { cos, sin } = trig::at_angle(theta.0);
    fast((cos.value(), sin.value()))
}

const fn constant(pair: Pair<f32>) -> Fast<f32> {
    Fast(pair.hi)
}

impl Kernel for Fast<f32> {
    type Wide = Self;
    type Cosine = CosSin<Self>;
    type Scale = Self;
    type TailRoot = TailRoot;

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
        Fast(root::scaled_root(f(Fast(a.0 * root::UP)).0))
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
    fn at_turn(u: Self) -> CosSin<Self> {
        fast(angle::turn(u.0))
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
        let c = scale * factor;
        if !BY_SELECTS {
            return logarithmic::power_times(k, at, c);
        }
        let power = Self::exp_times(Self::ln_cos_power(k, at), c);
        let end = Self::select(k > Self::ZERO, Self::ZERO, Self::INFINITY);
        let end = Self::select(k == Self::ZERO, c, end);
        Self::select(at.cos > Self::ZERO, power, end)
    }
    #[inline(always)]
    fn ln_power_times_sine(k: Self, at: CosSin<Self>, c: Self) -> Self {
        logarithmic::ln_power_times_sine(k, at, c)
    }
    #[inline(always)]
    fn power_tails(n: Self, at: CosSin<Self>) -> (Self, Self) {
        if !BY_SELECTS {
            return logarithmic::power_tails(n, at);
        }
        let a = Self::ln_cos_power(n, at);
        let inside = at.cos > Self::ZERO;
        (
            Self::select(inside, Self::one_minus_exp(a), Self::ONE),
            Self::select(inside, Self::exp_times(a, Self::ONE), Self::ZERO),
        )
    }
    #[inline(always)]
    fn cube_warp(p: Tails<Self>) -> CosSin<Self> {
        fast(root::cube_warp(p.lower().0, p.upper().0))
    }
    #[inline(always)]
    fn fourth_power_warp(p: Tails<Self>) -> CosSin<Self> {
        fast(root::fourth_power_warp(p.lower().0, p.upper().0))
    }
    #[inline(always)]
    fn tail_root(n: Self) -> TailRoot {
        TailRoot::new(n.0)
    }
    #[inline(always)]
    fn power_warp(p: Tails<Self>, root: TailRoot) -> CosSin<Self> {
        fast(root.at(Tails::from_array(p.to_array().map(|x| x.0))))
    }
}

impl Logarithmic for Fast<f32> {
    #[inline(always)]
    fn ln_cos_power(k: Self, at: CosSin<Self>) -> Self {
        // Beside the axis −k·sin²θ/2, in an order that does not underflow for a k as large as
        // 1/sin²θ.
        Fast(root::choose::<{ BY_SELECTS }>(
            at.sin.0 < 1e-15,
            || -(k * at.sin * at.sin * Self::HALF).0,
            || (k * Self::ln_cos(at)).0,
        ))
    }
    #[inline(always)]
    fn exp_times(a: Self, c: Self) -> Self {
        Fast(power::exp_times(a.0, c.0))
    }
    #[inline(always)]
    fn one_minus_exp(a: Self) -> Self {
        Fast(power::one_minus_exp(a.0))
    }
}
