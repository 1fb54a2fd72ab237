//! What every number can do: the arithmetic that needs no kernel.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number: of the public interface or of the working arithmetic behind it.
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    const ZERO: Self;
    const QUARTER: Self;
    const HALF: Self;
    const ONE: Self;
    const INFINITY: Self;
    const NAN: Self;
    const MIN_NORMAL: Self;
    const MAX: Self;
    /// The largest number that is not above the true π/2.
    const HALF_PI_DOWN: Self;

    fn int(n: i16) -> Self;

    fn is_nan(self) -> bool;
    fn is_finite(self) -> bool;
    fn abs(self) -> Self;
    /// 1 for negative numbers and −0, else 0.
    fn sign_bit(self) -> u32;
    /// (b, a) if n is odd, else (a, b), by masking bits: random bits choose, and a branch on them
    /// would be mispredicted half the time.
    fn swap_if_odd(n: u32, a: Self, b: Self) -> (Self, Self);
    /// [`swap_if_odd`](Self::swap_if_odd) of numbers that are multiplied next.
    #[inline(always)]
    fn swap_factors_if_odd(n: u32, a: Self, b: Self) -> (Self, Self) {
        Self::swap_if_odd(n, a, b)
    }
    /// `a` if `first`, else `b`, in the same way.
    #[inline(always)]
    fn select(first: bool, a: Self, b: Self) -> Self {
        Self::swap_if_odd(u32::from(first), b, a).0
    }
    /// −self if n is odd.
    fn negate_if_odd(self, n: u32) -> Self;
    /// −self if `negative`.
    #[inline(always)]
    fn negate_if(self, negative: bool) -> Self {
        self.negate_if_odd(u32::from(negative))
    }
    fn copysign(self, sign: Self) -> Self;
    fn sqrt(self) -> Self;
    /// A number from 0 to 1 as it is, −0 as 0, any other as NaN.
    #[inline(always)]
    fn probability(self) -> Self {
        if self >= Self::ZERO && self <= Self::ONE {
            self.abs()
        } else {
            Self::NAN
        }
    }
    /// Two [probabilities](Scalar::probability); if either is none, the first is NaN and the second
    /// some number.
    #[inline(always)]
    fn probabilities(a: Self, b: Self) -> (Self, Self) {
        one_by_one(a, b)
    }
}

/// Whether rare cases are selected, as loops of vectors need, not branched to: on 32-bit processors
/// an operation may be a routine. Always the same bits.
pub(crate) const BY_SELECTS: bool = cfg!(target_pointer_width = "64");

/// [`Scalar::probabilities`], each checked by itself.
#[inline(always)]
pub(crate) fn one_by_one<T: Scalar>(a: T, b: T) -> (T, T) {
    if b >= T::ZERO && b <= T::ONE {
        (a.probability(), b.abs())
    } else {
        (T::NAN, T::NAN)
    }
}
