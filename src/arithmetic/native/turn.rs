//! (cos 2πu, sin 2πu) of an angle in turns, with no range reduction to lose digits in.

use super::pair::Pair;
use super::poly::{by_twos, horner};
use crate::CosSin;
use crate::arithmetic::native::format::Native;
use crate::scalar::Scalar;

/// (cos, sin) of 2πx = `slope`·`arg` for |x| ≤ 1/8, where `slope` is 2π times `share`; `sum` is
/// that of powers.
#[inline(always)]
fn eighth<T: Native>(
    x: T,
    arg: T,
    slope: Pair<T>,
    share: T,
    sum: impl Fn(T, &[T]) -> T,
) -> CosSin<T> {
    let v = x * x;
    let bend = v * share * sum(v, T::TABLE.sin_turn);
    CosSin {
        cos: T::ONE + v * sum(v, T::TABLE.cos_turn),
        sin: arg * slope.hi + arg * (slope.lo + bend),
    }
}

/// (cos, sin) at `quadrant`/4 + x turns, |x| ≤ 1/8: of a sample, which waits for its last word.
#[inline(always)]
pub(crate) fn at_quadrant<T: Native>(quadrant: u32, x: T) -> CosSin<T> {
    into_quadrant(quadrant, eighth(x, x, T::CONSTANTS.two_pi, T::ONE, by_twos))
}

/// The direction `at`, turned on by `quadrant` right angles.
#[inline(always)]
pub(crate) fn into_quadrant<T: Scalar>(quadrant: u32, at: CosSin<T>) -> CosSin<T> {
    let behind = quadrant >> 1;
    let (cos, sin) = (at.cos.negate_if_odd(behind), at.sin.negate_if_odd(behind));
    let (cos, sin) = T::swap_factors_if_odd(quadrant, cos, sin);
    CosSin {
        cos: cos.negate_if_odd(quadrant),
        sin,
    }
}

/// The patterns (a, b), or (b, a) if n is odd, for a processor that selects integers in an
/// instruction.
///
/// Not by their difference: a compiler puts two `f32` into one vector of four, and the difference
/// into its unused lanes. It is mostly a subnormal number, with which every product takes a hundred
/// cycles more (`Lambert` took twice the time).
#[inline(always)]
pub(crate) fn select_if_odd<B>(n: u32, a: B, b: B) -> (B, B) {
    if n & 1 != 0 { (b, a) } else { (a, b) }
}

/// (q, x): u turns as the nearest q quarters and x turns, for 0 ≤ u ≤ 1.
///
/// A sum whose last place is a quarter rounds to one, and counts them in its last bits: no
/// conversion.
#[inline(always)]
pub(crate) fn nearest_quarter<T: Native>(u: T) -> (u32, T) {
    let sum = u + T::COUNTS_QUARTERS;
    (sum.last_bits(), u - (sum - T::COUNTS_QUARTERS))
}

/// (cos, sin) at u turns, 0 ≤ u ≤ 1.
#[inline(always)]
pub(crate) fn at_turn<T: Native>(u: T) -> CosSin<T> {
    let (quadrant, x) = nearest_quarter(u);
    into_quadrant(quadrant, eighth(x, x, T::CONSTANTS.two_pi, T::ONE, horner))
}

/// (cos, sin) of the angle πp from an end, 0 ≤ p ≤ 1/2: cos is that of the angle from the axis.
#[inline(always)]
pub(crate) fn half_turn<T: Native>(p: T) -> CosSin<T> {
    let d = T::HALF - p;
    // The argument stays p: half a subnormal p would lose its last bit.
    let arg = if p < d { p } else { d };
    let CosSin { cos, sin } = eighth(arg * T::HALF, arg, T::CONSTANTS.pi, T::HALF, horner);
    let (cos, sin) = T::swap_if_odd((p - d).sign_bit(), cos, sin);
    CosSin { cos, sin }
}
