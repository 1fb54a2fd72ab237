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
