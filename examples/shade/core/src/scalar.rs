//! What sealed supertraits of `Real` have, for types that are named as an associated type.

use crate::Number;

/// 0.
#[inline(always)]
pub(crate) fn zero<T: Number>() -> T {
    T::ZERO
}
/// 1.
#[inline(always)]
pub(crate) fn one<T: Number>() -> T {
    T::ONE
}
/// ½.
#[inline(always)]
pub(crate) fn half<T: Number>() -> T {
    T::HALF
}
/// ∞.
#[inline(always)]
pub(crate) fn infinity<T: Number>() -> T {
    T::INFINITY
}
/// n.
#[inline(always)]
pub(crate) fn int<T: Number>(n: i16) -> T {
    T::int(n)
}
/// |x|.
#[inline(always)]
pub(crate) fn abs<T: Number>(x: T) -> T {
    x.abs()
}
/// The smaller of the two.
#[inline(always)]
pub(crate) fn least<T: Number>(a: T, b: T) -> T {
    if a < b { a } else { b }
}
/// |x| with the sign of `sign`.
#[inline(always)]
pub(crate) fn copysign<T: Number>(x: T, sign: T) -> T {
    x.copysign(sign)
}
