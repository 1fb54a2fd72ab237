//! Quantiles never step back, and mirror where the law does.

use super::format::{Format, ulp};
use super::inputs::stratified;
use super::op::{AT_ANGLE, Op};
use super::part::Part;
use super::subject::Subject;
use coslobe::CosSin;
use rayon::prelude::*;

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
pub fn strided<T: Format>(s: &Subject<T>, stride: u64, part: Part) -> (u64, u64) {
    let one = T::of(1.0).bits();
    backward(
        s,
        part.share(one / stride)
            .into_par_iter()
            .map(move |i| i * stride),
    )
}

/// Some n stratified p of [0, 1).
pub fn sampled<T: Format>(s: &Subject<T>, n: u64, part: Part) -> (u64, u64) {
    let n = n - n % 3;
    let top = T::of(1.0).bits() - 1;
    backward(
        s,
        part.share(n)
            .into_par_iter()
            .map(move |i| stratified::<T>(top, i, n).bits()),
    )
}

/// The largest step back of `cdf` or of `sf` between neighbouring angles, in ulps, and the angle
/// below it: some n stratified angles.
pub fn tails_step_back<T: Format>(s: &Subject<T>, n: u64) -> (f64, u64) {
    let n = n - n % 3;
    let slots = [Op::Cdf, Op::Sf].map(|op| AT_ANGLE.iter().position(|&o| o == op));
    let tails = |bits: u64| {
        let theta = T::of_bits(bits);
        let all = s.law.at_angle(
            Some(theta),
            CosSin {
                cos: theta,
                sin: theta,
            },
        );
        slots.map(|slot| all[slot.expect("an operation at an angle")].wide())
    };
    let step = |i: u64| {
        let bits = stratified::<T>(T::TOP_ANGLE - 1, i, n).bits();
        let ([cdf, sf], [next_cdf, next_sf]) = (tails(bits), tails(bits + 1));
        let up = (cdf - next_cdf) / ulp::<T>(cdf);
        let down = (next_sf - sf) / ulp::<T>(sf);
        (up.max(down), bits)
    };
    let steps = (0..n).into_par_iter().map(step);
    steps.reduce(|| (0.0, 0), |a, b| if b.0 > a.0 { b } else { a })
}
