//! Roots: the f64 root and one Newton step. An f64 root is off by half an ulp or one, so that the
//! step's own error, its square, is below 2⁻¹⁰⁵.

use super::arith::Double;
use super::arith::{gap, product, square_raw};
use crate::arithmetic::native::cbrt;

/// √x for finite x > 0.
#[inline]
pub(crate) fn sqrt_of_positive(x: Double) -> Double {
    let root = libm::sqrt(x.hi);
    let rest = gap(x, Double::two_prod(root, root));
    Double::fast_two_sum(root, rest / (root + root))
}

/// √x; NaN for x < 0.
#[inline]
pub(crate) fn sqrt(x: Double) -> Double {
    if x.hi > 0.0 && x.hi.is_finite() {
        sqrt_of_positive(x)
    } else {
        Double::from_f64(libm::sqrt(x.hi))
    }
}

/// ∛x for x ≥ 0; NaN for x < 0.
#[inline]
pub(crate) fn cbrt(x: Double) -> Double {
    if !(x.hi > 0.0 && x.hi.is_finite()) {
        return Double::from_f64(libm::sqrt(x.hi));
    }
    let root = cbrt::cbrt(x.hi);
    let square = square_raw(Double::from_f64(root));
    let rest = gap(x, product(square, Double::from_f64(root)));
    Double::fast_two_sum(root, rest / (3.0 * square.hi))
}
