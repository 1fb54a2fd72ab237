//! From a generator's words to the numbers that samplers start from.

use super::Q31;
use super::turn::quarter;
use crate::CosSin;
use crate::integers::drawn::Drawn;
use crate::integers::format::Format;
use crate::integers::kernel::mul::mul_high;
use crate::integers::kernel::signed;
use ::fixed::types::I1F31;
use rand_core::TryRng;

/// The largest of N uniform words, X, in Q64.
///
/// X has the law of U^(1/N): a maximum costs a comparison where a root costs a hundred
/// instructions, and is as fine near 0 as the word itself. Near 1 it continues with the bits of
/// the words that lost: given the maximum they are uniform below it, so their exclusive or is
/// uniform (to 1 − X, relatively).
#[inline(always)]
pub(crate) fn largest<const N: usize, R: TryRng + ?Sized>(
    rng: &mut R,
) -> Result<(u32, u32), R::Error> {
    let (mut largest, mut mixed) = (0, 0);
    for _ in 0..N {
        let word = rng.try_next_u32()?;
        largest = word.max(largest);
        mixed ^= word;
    }
    Ok((largest, mixed ^ largest))
}

/// 1 − X in Q64, never 0.
#[inline(always)]
pub(crate) fn less((high, low): (u32, u32)) -> u64 {
    (u64::from(!high) << 32) | u64::from(!low | 1)
}

/// Two words as one, the first on top.
#[inline(always)]
pub(crate) fn long<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
    let high = rng.try_next_u32()?;
    Ok((u64::from(high) << 32) | u64::from(rng.try_next_u32()?))
}

/// \[sin θ cos φ, cos θ, sin θ sin φ\] for an azimuth of one more word.
#[inline(always)]
pub(crate) fn spatial<R: TryRng + ?Sized>(
    cos: u32,
    sin: u32,
    rng: &mut R,
) -> Result<Drawn<[I1F31; 3]>, R::Error> {
    let phase = rng.try_next_u32()?;
    let (x, z) = quarter(phase << 2);
    let swap = (x ^ z) & (((phase << 1) as i32) >> 31) as u32;
    let (cos, sin) = (Q31::inside(cos), Q31::inside(sin));
    let along = |part: u32, sign| I1F31::from_bits(signed(mul_high(sin << 1, part), sign));
    let direction = [
        along(x ^ swap, phase ^ (phase << 1)),
        I1F31::from_bits(cos as i32),
        along(z ^ swap, phase),
    ];
    let at = CosSin {
        cos: cos as i32,
        sin: sin as i32,
    };
    Ok(Drawn { direction, at })
}
