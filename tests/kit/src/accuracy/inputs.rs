//! Stratified arguments: by decade, linearly, and crowding towards the top of the range.

use super::format::Format;
use super::reference::Id;

/// Exponents that `CosPower` is judged at: those that the format holds.
pub fn exponents<T: Format>() -> Vec<Id> {
    let all = [0.0, 0.5, 1.0, 20.0, 1e6, 1e30, 1e300];
    let held = all.into_iter().filter(|&k| k <= T::MAX_VALUE);
    held.map(Id::CosPower).collect()
}

/// A fixed scramble of the index, for jitter within a stratum (SplitMix64's finaliser).
fn scramble(i: u64) -> u64 {
    let mut z = i.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// The i-th of n strata of a third of the inputs each: equal shares of bit patterns (every decade
/// alike), of the range itself, and of the decades of distance from its top.
pub fn stratified<T: Format>(top: u64, i: u64, n: u64) -> T {
    let share = n / 3;
    let (kind, j) = (i / share, i % share);
    let position = (j as f64 + scramble(i) as f64 / 2f64.powi(64)) / share as f64;
    let largest = T::of_bits(top).wide();
    let x = match kind {
        0 => return T::of_bits((top as f64 * position) as u64),
        1 => T::of(largest * position),
        // Steps of 1 to 2⁴⁰ (f64) or 2²⁰ (f32) last places below the top.
        _ => return T::of_bits(top - 2f64.powf(position * 0.75 * f64::from(T::DIGITS)) as u64),
    };
    if x.bits() > top { T::of_bits(top) } else { x }
}
