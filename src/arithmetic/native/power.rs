//! cosᵏθ for any real k, as 2 to the k·log₂ cos θ.
//!
//! k multiplies the relative error of the logarithm by up to 150 (`f32`) or 1100 (`f64`) before
//! cosᵏθ underflows, so the logarithm and the product keep eight bits beyond the format; what
//! follows does not.

use super::exp2::{Scale, exp2_m1, whole_and_rest};
use super::format::Native;
use super::log2::log2;
use super::pair::Pair;
use super::trig::sine_at_angle;
use crate::CosSin;

/// cos θ as its powers are taken: the smaller of cos θ and sin θ, and whether that is cos θ.
#[derive(Clone, Copy)]
pub struct Cosine<T> {
    small: Pair<T>,
    far: bool,
}

/// Of a direction.
#[inline(always)]
pub(crate) fn cosine<T: Native>(at: CosSin<T>) -> Cosine<T> {
    let far = at.cos <= at.sin;
    Cosine {
        small: Pair::from_value(T::select(far, at.cos, at.sin)),
        far,
    }
}

/// Of an angle within the support, and sin θ.
#[inline(always)]
pub(crate) fn cosine_at_angle<T: Native>(theta: T) -> (Cosine<T>, T) {
    let (small, far, cos) = sine_at_angle(theta);
    (Cosine { small, far }, T::select(far, cos, small.value()))
}

/// A multiple of log₂ cos θ.
#[derive(Clone, Copy)]
struct Log<T> {
    log: Pair<T>,
    /// log₂ cos θ is `log` times this power of two.
    share: T,
    /// cos θ is 0.
    nil: bool,
}

/// From cos θ or from 1 − sin²θ: near the axis the digits are in sin²θ.
#[inline(always)]
fn log_cosine<T: Native>(at: Cosine<T>) -> Log<T> {
    let Cosine { small, far } = at;
    // sin²θ must keep digits that a large k brings up again.
    let tiny = small.hi < T::TINY_SINE;
    let up = T::select(tiny, T::TINY_UP, T::ONE);
    let sine = small.hi * up;
    let square = Pair::two_prod(sine, sine);
    let square_lo = square.lo + (sine + sine) * (small.lo * up);
    let turned = square.hi > T::TABLE.log_turn;
    let two = T::ONE + T::ONE;
    let near = T::select(turned, T::ONE - two * square.hi, -square.hi);
    let near_lo = -T::select(turned, two, T::ONE) * square_lo;
    let (m, e) = small.hi.split(T::TABLE.log_parts[0].from);
    let e = if far {
        e
    } else {
        i32::from(turned).wrapping_neg()
    };
    let f = T::select(far, m - T::ONE, near);
    let low = T::select(
        far,
        small.lo * T::exp2(e.max(T::LEAST_EXPONENT).wrapping_neg()),
        near_lo,
    );
    Log {
        log: log2(e, f, low),
        share: T::select(far, T::ONE, T::select(tiny, T::TINY_SHARE, T::HALF)),
        nil: far & (small.hi == T::ZERO),
    }
}

/// k·log₂ cos θ.
#[inline(always)]
fn log_power<T: Native>(k: Pair<T>, at: Log<T>) -> Pair<T> {
    let (k_head, log_head) = (k.hi.leading_half(), at.log.hi.leading_half());
    let k_rest = (k.hi - k_head) + k.lo;
    let rest = k_head * ((at.log.hi - log_head) + at.log.lo) + k_rest * (at.log.hi + at.log.lo);
    let hi = k_head * log_head * at.share;
    let nothing = -(k.hi * T::INFINITY);
    Pair {
        hi: T::select(at.nil & (k.hi != T::ZERO), nothing, hi),
        lo: rest * at.share,
    }
}

/// `scale`·cosᵏθ·`factor`.
#[inline(always)]
pub(crate) fn power_times<T: Native>(k: Pair<T>, at: Cosine<T>, scale: Scale<T>, factor: T) -> T {
    let y = log_power(k, log_cosine(at));
    let (n, r) = whole_and_rest(y);
    let value = scale.times(exp2_m1(r).value(), n, factor);
    let value = T::select(y.hi < -T::EXPONENT_LIMIT, T::ZERO, value);
    T::select(y.hi > T::EXPONENT_LIMIT, T::INFINITY, value)
}

/// (1 − cosⁿθ, cosⁿθ) for n ≥ 1.
#[inline(always)]
pub(crate) fn power_tails<T: Native>(n: Pair<T>, at: Cosine<T>) -> (T, T) {
    let y = log_power(n, log_cosine(at));
    let (whole, r) = whole_and_rest(y);
    let p = exp2_m1(r);
    let one = Scale {
        significand: Pair::from_value(T::ONE),
        exponent: 0,
    };
    let upper = one.times(p.value(), whole, T::ONE);
    let power = T::exp2(whole.max(T::LEAST_EXPONENT));
    let lower = ((T::ONE - power) - power * p.hi) - power * p.lo;
    // n sin²θ/2, where sin²θ may have underflown.
    let s = at.small.hi;
    let square = Pair::two_prod(s * T::LIFT, s * T::LIFT);
    let slight = n.hi * square.hi + (n.hi * square.lo + n.lo * square.hi);
    let slight = slight * (T::HALF * T::DROP) * T::DROP;
    let lower = T::select((y.hi > -T::SLIGHT) & (s < T::LIFT_BELOW), slight, lower);
    let beyond = y.hi < -T::EXPONENT_LIMIT;
    (
        T::select(beyond, T::ONE, lower),
        T::select(beyond, T::ZERO, upper),
    )
}

/// ln x for finite x > 0.
#[inline]
pub(crate) fn ln<T: Native>(x: Pair<T>) -> Pair<T> {
    let (m, e) = x.hi.split(T::TABLE.log_parts[0].from);
    log2(e, m - T::ONE, x.lo.scale(e.wrapping_neg())).mul(T::CONSTANTS.ln_2)
}

/// k·ln cos θ + ln sin θ + c, −∞ where cos θ or sin θ is 0. Summed in pairs, since its terms
/// cancel where the density passes 1.
#[inline(always)]
pub(crate) fn ln_power_times_sine<T: Native>(k: Pair<T>, at: Cosine<T>, c: Pair<T>) -> T {
    // In quarters: log₂ overflows before ln does.
    let quarter = Pair {
        hi: k.hi * T::QUARTER,
        lo: k.lo * T::QUARTER,
    };
    let cos = log_power(quarter, log_cosine(at));
    let other = Cosine { far: !at.far, ..at };
    let sin = log_cosine(other);
    let nil = sin.nil | (cos.hi == -T::INFINITY);
    let sin = Pair {
        hi: sin.log.hi * sin.share * T::QUARTER,
        lo: sin.log.lo * sin.share * T::QUARTER,
    };
    let four_ln_2 = Pair {
        hi: T::CONSTANTS.ln_2.hi * T::int(4),
        lo: T::CONSTANTS.ln_2.lo * T::int(4),
    };
    let ln = Pair::fast_two_sum(cos.hi, cos.lo)
        .add(Pair::fast_two_sum(sin.hi, sin.lo))
        .mul(four_ln_2)
        .add(c)
        .value();
    // An overflow leaves ∞ − ∞ in a pair.
    T::select(nil | ln.is_nan(), -T::INFINITY, ln)
}
