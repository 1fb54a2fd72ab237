//! Uniform numbers from one 32-bit word.

use super::coefficients::{TURN_COS, TURN_SIN};
use super::fixed::{leading_30, leading_31};
use crate::arithmetic::native::turn::merge_if_odd;
use crate::arithmetic::native::uniform::f32::tail_of_half;

/// A nearer tail and whether it is the upper one: the top bit is the side, the others n give (2n +
/// 1)·2⁻³³.
///
/// Never 0, at most ½; 2⁻³³ is the deepest.
#[inline(always)]
pub(crate) fn tail(bits: u32) -> (f32, bool) {
    (tail_of_half(bits), bits >> 31 != 0)
}

/// (cos, sin) of the azimuth (bits + ½)·2⁻³² turns.
#[inline]
pub(crate) fn turn(bits: u32) -> (f32, f32) {
    let quadrant = bits.wrapping_add(1 << 29) >> 30;
    let rest = bits.wrapping_sub(quadrant << 30) as i32; // ±2²⁹, of 2³² to the turn
    let y = rest >> 14; // eighths of a turn, Q15
    let v = y.wrapping_mul(y) >> 14;
    let cos = leading_30(TURN_COS.at(v), 0).to_bits();
    let sin = ((rest << 1 | 1) as f32 * leading_31(TURN_SIN.at(v), -31)).to_bits();
    let (cos, sin) = merge_if_odd(quadrant, cos, sin);
    let cos_sign = (quadrant.wrapping_add(1) << 30) & (1 << 31);
    let sin_sign = (quadrant << 30) & (1 << 31);
    (
        f32::from_bits(cos ^ cos_sign),
        f32::from_bits(sin ^ sin_sign),
    )
}
