//! (cos 2πu, sin 2πu) of an angle in turns, with no range reduction to lose digits in.

use super::pair::Pair;
use super::poly::horner;
use crate::CosSin;
use crate::arithmetic::native::format::Native;
use crate::scalar::Scalar;

/// (cos, sin) of 2πx = `slope`·`arg` for |x| ≤ 1/8, where `slope` is 2π times `share`.
#[inline(always)]
fn eighth<T: Native>(x: T, arg: T, slope: Pair<T>, share: T) -> CosSin<T> {
    let v = x * x;
    let bend = v * share * horner(v, T::TABLE.sin_turn);
    CosSin {
        cos: T::ONE + v * horner(v, T::TABLE.cos_turn),
        sin: arg * slope.hi + arg * (slope.lo + bend),
    }
}

/// The pair at `quadrant`/4 + x turns, |x| ≤ 1/8.
#[inline]
pub(crate) fn at_quadrant<T: Native>(quadrant: u32, x: T) -> CosSin<T> {
    into_quadrant(quadrant, eighth(x, x, T::CONSTANTS.two_pi, T::ONE))
}

/// The pair `at` turned on by `quadrant` right angles.
#[inline(always)]
pub(crate) fn into_quadrant<T: Scalar>(quadrant: u32, at: CosSin<T>) -> CosSin<T> {
    let (cos, sin) = T::swap_factors_if_odd(quadrant, at.cos, at.sin);
    let behind = quadrant >> 1;
    CosSin {
        cos: cos.negate_if_odd(quadrant ^ behind),
        sin: sin.negate_if_odd(behind),
    }
}

/// The patterns (a, b), or (b, a) if n is odd.
///
/// By their difference, which takes the fewest instructions; on x86 by masks. Its compilers lay two `f32` into one vector
/// of four, whose idle lanes would hold the difference: a denormal number as a rule, and a hundred cycles
/// for each product with it (`Lambert` took twice the time). A mask leaves them 0.
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

/// The pair at u turns, 0 ≤ u ≤ 1.
#[inline]
pub(crate) fn at_turn<T: Native>(u: T) -> CosSin<T> {
    let quadrant = (u * T::int(4) + T::HALF).to_u32();
    at_quadrant(quadrant, u - T::int(quadrant as i16) * T::QUARTER)
}

/// (cos, sin) of the angle πp from an end, 0 ≤ p ≤ 1/2: cos is that of the angle from the axis.
#[inline]
pub(crate) fn half_turn<T: Native>(p: T) -> CosSin<T> {
    let d = T::HALF - p;
    // The argument stays p: half a subnormal p would lose its last bit.
    let arg = if p < d { p } else { d };
    let CosSin { cos, sin } = eighth(arg * T::HALF, arg, T::CONSTANTS.pi, T::HALF);
    let (cos, sin) = T::swap_if_odd((p - d).sign_bit(), cos, sin);
    CosSin { cos, sin }
}
