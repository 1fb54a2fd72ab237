//! (cos, sin) to an angle in turns.

use super::coefficients::ASIN;
use crate::integers::kernel::mul::{mul_high, mul_high_signed};

/// cos π/8 and sin π/8 in Q32.
const COS: u32 = 3968032378;
const SIN: u32 = 1643612827;
/// √½ in Q32, and the two units by which a rounded component may exceed it.
const HALF_ROOT: u32 = 3037000500 + 4;

/// The angle in the first quadrant, in turns of 2³², of |cos| and |sin| in Q31.
///
/// Turned back by π/8 (1/16 turn), whose sine is short for a polynomial and reads both components.
#[inline(always)]
pub(crate) fn first_quadrant(cos: u32, sin: u32) -> u32 {
    let (cos, sin) = (cos.wrapping_sub(cos >> 31), sin.wrapping_sub(sin >> 31));
    let (small, large) = if sin < cos { (sin, cos) } else { (cos, sin) };
    // A pair of unit length is not cut by this; any other stays in the polynomial's domain.
    let small = (small << 1).min(HALF_ROOT);
    let turned = mul_high(small, COS).wrapping_sub(mul_high(large << 1, SIN)) as i32;
    let square = mul_high_signed(turned, turned);
    let angle = (mul_high_signed(turned, ASIN.at(square)).wrapping_add(1 << 28)).max(0) as u32;
    if sin < cos {
        angle
    } else {
        (1u32 << 30).wrapping_sub(angle)
    }
}
