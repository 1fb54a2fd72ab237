//! Quantiles never step back, and mirror where the law does.

use super::format::Format;
use super::inputs::stratified;
use super::subject::Subject;
use rayon::prelude::*;

/// Whether a number type promises it: a relative error of 2⁻¹² leaves room for steps either way.
pub fn promised(tier: &str) -> bool {
    !tier.starts_with("Fast<")
}

/// Steps back of `quantile` and `isf` between p and its upper neighbour, over the arguments, and
/// the argument of the first.
fn backward<T: Format>(s: &Subject<T>, arguments: impl ParallelIterator<Item = u64>) -> (u64, u64) {
    arguments
        .map(|bits| {
            let (p, next) = (T::of_bits(bits), T::of_bits(bits + 1));
            let up = s.law.quantile(next) < s.law.quantile(p);
            let down = s.law.isf(next) > s.law.isf(p);
            let mirrored = !s.id.planar() || s.law.quantile(p) == -s.law.isf(p);
            let bad = u64::from(up) + u64::from(down) + u64::from(!mirrored);
            (bad, if bad > 0 { bits } else { u64::MAX })
        })
        .reduce(|| (0, u64::MAX), |a, b| (a.0 + b.0, a.1.min(b.1)))
}

/// Every `stride`-th p of [0, 1).
pub fn strided<T: Format>(s: &Subject<T>, stride: u64) -> (u64, u64) {
    let one = T::of(1.0).bits();
    backward(
        s,
        (0..one / stride).into_par_iter().map(move |i| i * stride),
    )
}

/// Some n stratified p of [0, 1).
pub fn sampled<T: Format>(s: &Subject<T>, n: u64) -> (u64, u64) {
    let n = n - n % 3;
    let top = T::of(1.0).bits() - 1;
    backward(
        s,
        (0..n)
            .into_par_iter()
            .map(move |i| stratified::<T>(top, i, n).bits()),
    )
}
