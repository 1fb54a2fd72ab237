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
    let (cos, sin) = T::swap_factors_if_odd(quadrant, at.cos, at.sin);
    let behind = quadrant >> 1;
    CosSin {
        // Each sign in its place already: one operation less than their sum.
        cos: cos.negate_if_odd(quadrant).negate_if_odd(behind),
        sin: sin.negate_if_odd(behind),
    }
}

/// The patterns (a, b), or (b, a) if n is odd.
///
/// By their difference, which takes the fewest instructions; on x86 by masks. There a compiler
/// puts the two `f32` into one vector of four, and their difference into its unused lanes. It is
/// mostly a subnormal number, with which every product takes a hundred cycles more (`Lambert` took
/// twice the time); masks leave zeros there.
#[inline(always)]
pub(crate) fn merge_if_odd(n: u32, a: u32, b: u32) -> (u32, u32) {
    if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
        let swap = ((n << 31) as i32 >> 31) as u32;
        ((a & !swap) | (b & swap), (b & !swap) | (a & swap))
    } else {
        let difference = (a ^ b) & (n & 1).wrapping_neg();
        (a ^ difference, b ^ difference)
    }
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
