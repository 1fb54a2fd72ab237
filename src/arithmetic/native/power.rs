//! cosᵏθ for any real k: ln cos θ as a pair, times k, through one exponential.
//!
//! k multiplies the relative error of ln cos θ by up to 745 before cosᵏθ underflows, so the
//! logarithm is kept to about ten bits beyond the format.

use super::pair::Pair;
use super::poly::horner_pair;
use crate::arithmetic::native::format::Native;
use crate::{CosSin, Tails};

/// ln(2ᵉ(1 + f)) for −0.3 < f < 0.42.
#[inline]
fn ln_scaled<T: Native>(f: Pair<T>, e: i32) -> Pair<T> {
    let z = f.div(Pair::exact(T::int(2)).add(f));
    let w = z.mul(z);
    let atanh = z.mul(w).mul(horner_pair(w, &T::TABLE.atanh_series)).add(z);
    let e = Pair::exact(T::from_i32(e));
    atanh.add(atanh).add(e.mul(T::CONSTANTS.ln_2))
}

/// ln x for finite x > 0.
#[inline]
pub(crate) fn ln<T: Native>(x: Pair<T>) -> Pair<T> {
    let (m, e) = x.hi.split();
    ln_scaled(Pair::two_sum(m - T::ONE, x.lo.scale(-e)), e)
}

/// ln cos θ for cos θ > 0, from the smaller of cosine and sine.
#[inline]
fn ln_cos<T: Native>(at: CosSin<Pair<T>>) -> Pair<T> {
    if at.cos.hi < at.sin.hi {
        return ln(at.cos);
    }
    let square = at.sin.mul(at.sin).neg();
    // Near the axis 1 − sin²θ must not be formed: the digits are in sin²θ.
    let ln_square = if square.hi > -T::QUARTER {
        ln_scaled(square, 0)
    } else {
        ln(Pair::exact(T::ONE).add(square))
    };
    ln_square.half()
}

/// k·ln cos θ for cos θ > 0.
#[inline]
pub(crate) fn ln_cos_power<T: Native>(k: Pair<T>, at: CosSin<Pair<T>>) -> Pair<T> {
    let product = if at.sin.hi < T::NEGLIGIBLE {
        // −k·sin²θ/2, in an order that does not underflow for a k as large as 1/sin²θ.
        k.mul(at.sin).mul(at.sin).half().neg()
    } else {
        k.mul(ln_cos(at))
    };
    // An overflow leaves ∞ − ∞ in the pair; the logarithm is negative, so k tells the sign.
    if product.hi.is_finite() {
        product
    } else if k.hi > T::ZERO {
        Pair::exact(-T::INFINITY)
    } else {
        Pair::exact(T::INFINITY)
    }
}

/// c·eᵃ; the scaling by a power of two comes last, so that neither factor overflows alone.
#[inline]
pub(crate) fn exp_times<T: Native>(a: Pair<T>, c: Pair<T>) -> T {
    let limit = T::int(4000);
    if a.hi < -limit {
        return T::ZERO;
    }
    if a.hi > limit {
        return c.hi * T::INFINITY;
    }
    let turns = a.hi / T::CONSTANTS.ln_2.hi;
    let n = (turns + T::HALF.copysign(turns)).to_i32();
    let r = a.add(Pair::exact(T::from_i32(-n)).mul(T::CONSTANTS.ln_2));
    let m = r.hi.exp();
    (c.value() * (m + m * r.lo)).scale(n)
}

/// 1 − eᵃ.
#[inline]
pub(crate) fn one_minus_exp<T: Native>(a: Pair<T>) -> T {
    let m = a.hi.exp_m1();
    -(m + a.lo * (T::ONE + m))
}

/// (cos θ, sin θ) with cosⁿθ = the upper tail: through the exponential of a pair.
#[inline]
pub(crate) fn warp<T: Native>(p: Tails<T>, n: Pair<T>) -> CosSin<T> {
    let (lower, upper) = (p.lower(), p.upper());
    if upper == T::ZERO {
        return CosSin {
            cos: T::ZERO,
            sin: T::ONE,
        };
    }
    let log = if upper < T::HALF {
        ln(Pair::exact(upper))
    } else {
        Pair::exact((-lower).ln_1p())
    };
    let a = log.div(n);
    let twice = a.add(a);
    let sin = if -a.hi < T::NEGLIGIBLE * T::NEGLIGIBLE {
        // sin²θ = −2a, which for large n underflows before its root does.
        (-(log.hi + log.hi)).sqrt() / n.hi.sqrt()
    } else {
        one_minus_exp(twice).sqrt()
    };
    CosSin {
        cos: exp_times(a, Pair::exact(T::ONE)),
        sin,
    }
}
