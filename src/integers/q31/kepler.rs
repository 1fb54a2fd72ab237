//! Kepler's equation at e = 1: the angle at a tail of the disk's law.

use super::coefficients::{KEPLER, KEPLER_MIDDLE};
use crate::integers::kernel::mul::mul_high;

/// The angle from the nearer end in quarter turns, Q32 (1 saturates), at z = ∛p in Q32, p ≤ ½.
///
/// Over z it is analytic in z²: one polynomial, no iteration.
#[inline(always)]
pub(crate) fn from_end(z: u32) -> u32 {
    let square = mul_high(z, z);
    let x = (square.wrapping_add(square >> 1)).wrapping_sub(KEPLER_MIDDLE) as i32;
    // The sums are rounded down, by three units in the middle.
    let ratio = (KEPLER.at(x) as u32).wrapping_add(3);
    z.saturating_add(mul_high(z, ratio))
}
