//! Kepler's equation at e = 1: the angle at a tail of the disk's law.

use super::coefficients::{KEPLER, KEPLER_MIDDLE};

/// The angle from the nearer end in quarter turns, Q32 (1 saturates), at z = ∛p in Q32, p ≤ ½;
/// rounded to the 17 bits that [`quarter`](super::turn::quarter) reads.
#[inline(always)]
pub(crate) fn from_end(z: u32) -> u32 {
    let high = z >> 16;
    let square = high.wrapping_mul(high);
    let x = (square.wrapping_add(square >> 1)).wrapping_sub(KEPLER_MIDDLE) as i32;
    // The sums are rounded down, by two units in the middle.
    let more = (high.wrapping_mul((KEPLER.at(x) as u32).wrapping_add(2))) >> 2;
    let rounded = ((z >> 1).wrapping_add(more).wrapping_add(1 << 13)) >> 14;
    (rounded.wrapping_sub(rounded >> 17)) << 15
}
