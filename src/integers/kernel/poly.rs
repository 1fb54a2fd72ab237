//! Polynomials by Horner's rule in 32-bit words.

use super::mul::{mul_high, mul_high_signed};

/// Coefficients in one format, the leading one first. The sums of `small` are short enough for a
/// single 32-bit product with the upper half of x; from `large` on a step is the high half of a
/// long one.
pub(crate) struct Polynomial<T, const SMALL: usize, const LARGE: usize> {
    pub(crate) small: [T; SMALL],
    pub(crate) large: [T; LARGE],
}

impl<const SMALL: usize, const LARGE: usize> Polynomial<i32, SMALL, LARGE> {
    /// The value at x in Q32, |x| ≤ ½, in the format of the coefficients.
    #[inline(always)]
    pub(crate) fn at(&self, x: i32) -> i32 {
        let short = x >> 16;
        let sum = self.small.iter().fold(0, |sum: i32, &c| {
            ((sum.wrapping_mul(short)) >> 16).wrapping_add(c)
        });
        self.large
            .iter()
            .fold(sum, |sum, &c| mul_high_signed(sum, x).wrapping_add(c))
    }
}

impl<const SMALL: usize, const LARGE: usize> Polynomial<u32, SMALL, LARGE> {
    /// The same with signs that alternate, so that words need no sign and x goes from 0 to 1.
    #[inline(always)]
    pub(crate) fn at(&self, x: u32) -> u32 {
        let short = x >> 16;
        let sum = self.small.iter().fold(0, |sum: u32, &c| {
            c.wrapping_sub((sum.wrapping_mul(short)) >> 16)
        });
        self.large
            .iter()
            .fold(sum, |sum, &c| c.wrapping_sub(mul_high(sum, x)))
    }
}
