//! Cosine and sine of an angle, and the angle of a direction.

use super::arith::Double;
use super::arith::{add_raw, add_smaller, gap, mul_raw, normalise, square_raw};
use super::coefficients::{HALF_PI, PI, QUARTER_PI, SIN, TWO_PI};
use super::root::sqrt_of_positive;
use super::series::Series;
use crate::CosSin;

const HALF_PI_PAIR: Double = Double {
    hi: HALF_PI[0],
    lo: HALF_PI[1],
};

/// π/2 − a for 0 ≤ a ≤ π/2, with three parts of π/2: beside it, the first two cancel.
#[inline]
pub(crate) fn from_end(a: f64) -> Double {
    let d = Double::fast_two_sum(HALF_PI[0], -a);
    let s = Double::fast_two_sum(d.hi, HALF_PI[1]);
    Double::fast_two_sum(s.hi, s.lo + (d.lo + HALF_PI[2]))
}

/// π/2 − a for a pair with π/2 − a > 2⁻⁶⁵: the error is below 2⁻¹⁶⁰.
#[inline]
pub(crate) fn pair_from_end(a: Double) -> Double {
    let d = Double::two_sum(HALF_PI[0], -a.hi);
    let e = Double::two_sum(HALF_PI[1], -a.lo);
    let s = Double::two_sum(d.hi, e.hi);
    Double::fast_two_sum(s.hi, s.lo + (d.lo + (e.lo + HALF_PI[2])))
}

/// sin x − x, not normalised.
#[inline(always)]
pub(crate) fn sine_gap(x: Double, series: &Series) -> Double {
    let v = square_raw(x);
    mul_raw(x, mul_raw(v, series.sum(v)))
}

/// (cos x, sin x) for 0 ≤ x ≤ 0.9, and sin x − x. The cosine is √(1 − sin²x): cheaper than a
/// series of its own, and its error is that of the sine times tan²x < 1.6.
#[inline]
pub(crate) fn sin_cos_gap(x: Double) -> (CosSin<Double>, Double) {
    let rest = sine_gap(x, &SIN);
    let sin = add_smaller(x, rest);
    let square = add_raw(Double::from_f64(1.0), -square_raw(sin));
    let cos = sqrt_of_positive(square);
    (CosSin { cos, sin }, rest)
}

/// (cos x, sin x) for 0 ≤ x ≤ 0.9.
#[inline]
pub(crate) fn sin_cos(x: Double) -> CosSin<Double> {
    sin_cos_gap(x).0
}

/// (cos θ, |sin θ|) for |θ| ≤ π/2.
#[inline]
pub(crate) fn at_angle(theta: f64) -> CosSin<Double> {
    let a = theta.abs();
    if a > QUARTER_PI.hi {
        swapped(sin_cos(from_end(a)))
    } else {
        sin_cos(Double::from_f64(a))
    }
}

#[inline(always)]
pub(crate) fn swapped(at: CosSin<Double>) -> CosSin<Double> {
    CosSin {
        cos: at.sin,
        sin: at.cos,
    }
}

/// (cos 2πx, sin 2πx) for |x| ≤ ⅛.
#[inline]
pub(crate) fn at_eighth(x: Double) -> CosSin<Double> {
    sin_cos(normalise(mul_raw(x, TWO_PI)))
}

/// atan(y/x) for 0 ≤ y ≤ x, x > 0, from tan(φ − φ₀) = (y cos φ₀ − x sin φ₀)/(x cos φ₀ + y sin φ₀):
/// the (x, y) need not be a unit vector, and the tangent's cubic term is below 2⁻¹⁵⁰ of φ.
#[inline]
fn atan_of_ratio(y: Double, x: Double) -> Double {
    let start = libm::atan2(y.hi, x.hi);
    let CosSin { cos, sin } = sin_cos(Double::from_f64(start));
    let across = gap(mul_raw(y, cos), mul_raw(x, sin));
    let along = x.hi * cos.hi + y.hi * sin.hi;
    Double::fast_two_sum(start, across / along)
}

/// The angle of (x, y), with the signs, zeros and infinities of `f64::atan2`.
#[inline]
pub(crate) fn atan2(y: Double, x: Double) -> Double {
    if y.hi.is_nan() || x.hi.is_nan() {
        return Double::from_f64(f64::NAN);
    }
    let behind = x.hi.is_sign_negative();
    let below = y.hi.is_sign_negative();
    let x = if behind { -x } else { x };
    let y = if below { -y } else { y };
    let steep = y.hi > x.hi;
    let (small, large) = if steep { (x, y) } else { (y, x) };
    let angle = if small.hi == 0.0 || !large.hi.is_finite() {
        if small.hi.is_finite() {
            Double::from_f64(0.0)
        } else {
            QUARTER_PI
        }
    } else {
        atan_of_ratio(small, large)
    };
    let angle = match (steep, behind) {
        (false, false) => angle,
        (false, true) => add_smaller(PI, -angle),
        (true, false) => add_smaller(HALF_PI_PAIR, -angle),
        (true, true) => add_smaller(HALF_PI_PAIR, angle),
    };
    if below { -angle } else { angle }
}
