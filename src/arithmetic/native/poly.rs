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
    let Some((rest, &[s0, s1, s2, s3])) = c.split_last_chunk() else {
        return horner(x, c);
    };
    let x2 = x * x;
    let x4 = x2 * x2;
    // From the last term on; the sum that the next one belongs to stands first. Adapters such as
    // `step_by` are not always inlined, and a loop over slices would be none of vectors.
    let sums = rest.iter().rev();
    let [s3, s2, s1, s0] = sums.fold([s3, s2, s1, s0], |[next, a, b, c], &k| {
        [a, b, c, next * x4 + k]
    });
    (s0 + x2 * s2) + x * (s1 + x2 * s3)
}

/// Σ cᵢ xⁱ, of a long series even terms and odd ones by themselves: one product more.
#[inline(always)]
pub(crate) fn by_twos<T: Native>(x: T, c: &[T]) -> T {
    let Some((rest, &[a, b])) = c.split_last_chunk().filter(|_| c.len() > 4) else {
        return horner(x, c);
    };
    let x2 = x * x;
    // From the last term on; the sum that the next one belongs to stands last.
    let sums = rest.iter().rev();
    let [even, odd] = sums.fold([a, b], |[other, next], &k| [next * x2 + k, other]);
    even + x * odd
}
