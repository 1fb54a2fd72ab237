//! Sums of powers.

use crate::arithmetic::native::format::Native;

/// Σ cᵢ xⁱ.
#[inline(always)]
pub(crate) fn horner<T: Native>(x: T, c: &[T]) -> T {
    match c.split_last() {
        Some((&last, rest)) => rest.iter().rev().fold(last, |sum, &k| sum * x + k),
        None => T::ZERO,
    }
}

/// Σ cᵢ xⁱ for a long series: every fourth term by itself, so that the sums do not wait for each
/// other.
#[inline(always)]
pub(crate) fn by_fours<T: Native>(x: T, c: &[T]) -> T {
    let x2 = x * x;
    let x4 = x2 * x2;
    let sum = |i| {
        let terms = c.iter().copied().skip(i).step_by(4).rev();
        terms.reduce(|sum, k| sum * x4 + k).unwrap_or(T::ZERO)
    };
    (sum(0) + x2 * sum(2)) + x * (sum(1) + x2 * sum(3))
}

/// A polynomial of x in Q16: the leading coefficient in Qk, the others in Q(k + 16), the inner ones
/// with the half unit that rounds their sum to Qk.
pub(crate) struct FixedPoint<const N: usize> {
    pub(crate) first: u32,
    pub(crate) inner: [i32; N],
    pub(crate) last: i32,
}

impl<const N: usize> FixedPoint<N> {
    /// The value in Q(k + 16): the last sum keeps all its bits. Wraps for x outside the domain.
    #[inline(always)]
    pub(crate) fn at(&self, x: i32) -> u32 {
        let step = |sum: i32, &c: &i32| sum.wrapping_mul(x).wrapping_add(c) >> 16;
        let sum = self.inner.iter().rev().fold(self.last, step);
        (sum.wrapping_mul(x) as u32).wrapping_add(self.first)
    }
}
