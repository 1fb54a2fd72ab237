//! From a generator's words to the numbers that samplers start from.

use super::Q31;
use super::turn::quarter;
use crate::fixed::format::Format;
use crate::fixed::kernel::mul::mul_high;
use crate::fixed::kernel::signed;
use ::fixed::types::I1F31;
use rand_core::Rng;

/// The largest of N uniform words, X, in Q64.
///
/// X has the law of U^(1/N): a maximum costs a comparison where a root costs a hundred
/// instructions, and is as fine near 0 as the word itself. Near 1 it continues with the bits of
/// the words that lost: given the maximum they are uniform below it, so their exclusive or is
/// uniform (to 1 − X, relatively).
#[inline(always)]
pub(crate) fn largest<const N: usize, R: Rng + ?Sized>(rng: &mut R) -> (u32, u32) {
    let (mut largest, mut mixed) = (0, 0);
    for _ in 0..N {
        let word = rng.next_u32();
        largest = word.max(largest);
        mixed ^= word;
    }
    (largest, mixed ^ largest)
}

/// 1 − X in Q64, never 0.
#[inline(always)]
pub(crate) fn less((high, low): (u32, u32)) -> u64 {
    (u64::from(!high) << 32) | u64::from(!low | 1)
}

/// Two words as one uniform number in Q64, never 0; its lowest bit is free for a sign.
#[inline(always)]
pub(crate) fn long<R: Rng + ?Sized>(rng: &mut R) -> u64 {
    let high = rng.next_u32();
    (u64::from(high) << 32) | u64::from(rng.next_u32())
}

/// \[sin θ cos φ, cos θ, sin θ sin φ\] for an azimuth of one more word.
#[inline(always)]
pub(crate) fn spatial<R: Rng + ?Sized>(cos: u32, sin: u32, rng: &mut R) -> [I1F31; 3] {
    let phase = rng.next_u32();
    let (x, z) = quarter(phase << 2);
    let swap = (x ^ z) & (((phase << 1) as i32) >> 31) as u32;
    let sin = Q31::inside(sin) << 1;
    let along = |part: u32, sign: u32| I1F31::from_bits(signed(mul_high(sin, part), sign));
    [
        along(x ^ swap, phase ^ (phase << 1)),
        I1F31::from_bits(Q31::inside(cos) as i32),
        along(z ^ swap, phase),
    ]
}
