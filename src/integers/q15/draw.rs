//! From a generator's words to the numbers that samplers start from.

use super::root::{less_square, scaled};
use super::turn::eighth;
use super::word::ONE;
use crate::CosSin;
use crate::integers::drawn::Drawn;
use ::fixed::types::I1F15;
use rand_core::TryRng;

/// The larger of a word's halves, and below it the smaller: Q32.
#[inline(always)]
fn ordered(word: u32) -> u32 {
    word.max(word.rotate_right(16))
}

/// The largest of N = 2, 3 or 4 uniform half-words, in Q32, and the upper half that N = 3 leaves.
///
/// X has the law of U^(1/N). Near 1 it continues with the bits of the halves that lost: given the
/// maximum they are uniform below it, so their exclusive or is uniform (to 1 − X, relatively).
#[inline(always)]
pub(crate) fn largest<const N: usize, R: TryRng + ?Sized>(
    rng: &mut R,
) -> Result<(u32, u32), R::Error> {
    let first = rng.try_next_u32()?;
    if N == 2 {
        return Ok((ordered(first), 0));
    }
    let second = rng.try_next_u32()?;
    let (other, halves) = if N == 3 {
        (second << 16, second)
    } else {
        (ordered(second), second ^ (second >> 16))
    };
    let largest = ordered(first).max(other) >> 16;
    let mixed = first ^ (first >> 16) ^ halves ^ largest;
    Ok(((largest << 16) | (mixed & 0xFFFF), second & 0xFFFF_0000))
}

/// A magnitude in Q15 with the sign of `sign`'s top bit.
#[inline(always)]
fn signed(magnitude: u32, sign: u32) -> I1F15 {
    let mask = (sign as i32) >> 31;
    I1F15::from_bits(((magnitude as i32 ^ mask).wrapping_sub(mask)) as i16)
}

/// \[sin θ cos φ, cos θ, sin θ sin φ\] of cos θ in Q32, and an azimuth that needs no order: two
/// bits are the signs, one exchanges cos φ and sin φ, the next 16 are |φ| in eighths of a turn.
#[inline(always)]
pub(crate) fn spatial(cos: u32, phase: u32) -> Drawn<[I1F15; 3]> {
    let sin = scaled::<32>(less_square(cos), 0) >> 16;
    let (x, z) = eighth((phase << 3) >> 16);
    let swap = (x ^ z) & (((phase << 2) as i32) >> 31) as u32;
    // Both factors are rounded down, by half a unit in the middle; below 1, so that neither sum
    // overflows.
    let part = |q31: u32| {
        let part = q31 >> 15;
        (sin.wrapping_mul(part)
            .wrapping_add((sin.wrapping_add(part)) >> 1)
            .wrapping_add(0xFFFF))
            >> 17
    };
    // From 0 to 1, less one unit; and to at least one, without a comparison.
    let along = ((cos >> 16).wrapping_add(1)) >> 1;
    let along = along
        .wrapping_sub(along >> 15)
        .wrapping_add(along.wrapping_sub(1) >> 31);
    let direction = [
        signed(part(x ^ swap), phase << 1),
        I1F15::from_bits(along as i16),
        signed(part(z ^ swap), phase),
    ];
    let at = CosSin {
        cos: (along << 16) as i32,
        // Its last half unit would round to −1.
        sin: (sin << 15).min(ONE) as i32,
    };
    Drawn { direction, at }
}
