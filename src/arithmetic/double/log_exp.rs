//! Logarithms and exponentials.

use super::arith::Double;
use super::arith::{
    add_raw, add_smaller, mul_raw, normalise, product, quotient, scaled, square_raw, sum,
};
use super::coefficients::{ATANH, COTH, LN_2, LN_2_SHORT};
use crate::arithmetic::native::float::Float;

/// ln(1 + f) for √½ ≤ 1 + f ≤ √2, as 2 atanh(f/(2 + f)).
#[inline]
fn ln_near_one(f: Double) -> Double {
    let z = quotient(f, add_smaller(Double::from_f64(2.0), f));
    let w = square_raw(z);
    let rest = mul_raw(z, mul_raw(w, ATANH.sum(w)));
    scaled(add_smaller(z, rest), 2.0)
}

/// ln x; −∞ at 0, NaN for x < 0.
#[inline]
pub(crate) fn ln(x: Double) -> Double {
    if !(x.hi > 0.0 && x.hi.is_finite()) {
        return Double::from_f64(libm::log(x.hi));
    }
    let (m, e) = x.hi.split(f64::ROOT_HALF);
    let part = ln_near_one(Double::two_sum(m - 1.0, x.lo.scale(e.wrapping_neg())));
    if e == 0 {
        part
    } else {
        // |e|·ln 2 is at least twice the part, so nothing cancels.
        add_smaller(product(LN_2, Double::from_f64(f64::from(e))), part)
    }
}

/// ln(1 + x) for x > −1.
#[inline]
pub(crate) fn ln_1p(x: Double) -> Double {
    if x.hi > -0.29 && x.hi < 0.41 {
        ln_near_one(x)
    } else {
        ln(sum(Double::from_f64(1.0), x))
    }
}

/// eʳ − 1 for |r| ≤ 0.35, as 2r/(r coth(r/2) − r): the cotangent's series is even and short.
#[inline]
fn exp_m1_near_zero(r: Double) -> Double {
    let v = square_raw(r);
    let two = Double::from_f64(2.0);
    let even = add_raw(two, mul_raw(v, COTH.sum(v)));
    quotient(scaled(r, 2.0), add_smaller(even, -r))
}

/// eˣ = m·2ⁿ with ½ ≤ m < 2, for |x| up to 2¹¹; beyond, the error grows with x, and n = ±2²¹ stands
/// for all that is larger or smaller.
#[inline]
pub(crate) fn exp(x: Double) -> (Double, i32) {
    const LIMIT: f64 = 700_000.0;
    if x.hi > LIMIT {
        return (Double::from_f64(1.0), 1 << 21);
    }
    if x.hi < -LIMIT {
        return (Double::from_f64(1.0), -(1 << 21));
    }
    let turns = x.hi / LN_2.hi;
    let n = (turns + 0.5_f64.copysign(turns)) as i32;
    let k = -f64::from(n);
    // n < 2²⁰, so the products with the two short parts are exact.
    let first = Double::two_sum(x.hi, k * LN_2_SHORT[0]);
    let second = Double::two_sum(first.hi, k * LN_2_SHORT[1]);
    let r = Double::fast_two_sum(
        second.hi,
        second.lo + (first.lo + (x.lo + k * LN_2_SHORT[2])),
    );
    (add_smaller(Double::from_f64(1.0), exp_m1_near_zero(r)), n)
}

/// eˣ − 1 for x ≤ 0.
#[inline]
pub(crate) fn exp_m1(x: Double) -> Double {
    if x.hi.abs() < 0.34 {
        return exp_m1_near_zero(x);
    }
    let (m, n) = exp(x);
    let power = 1.0.scale(n);
    add_smaller(Double::from_f64(-1.0), normalise(scaled(m, power)))
}
