//! Powers at which rounding to a shorter format is a near thing.

use super::arith::Double;
use crate::arithmetic::native::f64::power_of_two;
use crate::scalar::Scalar;

/// A power within 2⁻⁹⁰ of an `f64` is taken to be that: c³ of a c with few digits must come out
/// exactly, since it can be a tie in a shorter format.
#[inline]
pub(crate) fn snapped(x: Double) -> Double {
    if x.lo.abs() < x.hi.abs() * power_of_two(-90) {
        Double::from_f64(x.hi)
    } else {
        x
    }
}

/// 1 − (1 − v)ᵐ for small mv, by the binomial series: beside the axis mv itself can be a tie in a
/// shorter format, and then the sign of the rest decides.
#[inline]
pub(crate) fn one_minus_power(m: Double, v: Double) -> Double {
    let mut rest = Double::ONE;
    for j in (1..7).rev() {
        let step = (m - Double::int(j)) * v / Double::int(j + 1);
        rest = if j == 1 {
            step * rest
        } else {
            Double::ONE - step * rest
        };
    }
    let first = m * v;
    first - first * rest
}
