//! (cos, sin) to an angle in turns.

use super::coefficients::ASIN;

/// cos π/8 and sin π/8 in Q16.
const COS: u32 = 60547;
const SIN: u32 = 25080;
/// √½ in Q16, and the units by which a rounded component may exceed it.
const HALF_ROOT: u32 = 46341 + 2;

/// The angle in the first quadrant, in turns of 2³², of |cos| and |sin| in Q31.
///
/// Turned back by π/8 (1/16 turn), whose sine is short for a polynomial and reads both components.
#[inline(always)]
pub(crate) fn first_quadrant(cos: u32, sin: u32) -> u32 {
    let (cos, sin) = (cos.wrapping_sub(cos >> 31), sin.wrapping_sub(sin >> 31));
    let (cos, sin) = (
        super::word::rounded(cos << 1),
        super::word::rounded(sin << 1),
    );
    let (small, large) = if sin < cos { (sin, cos) } else { (cos, sin) };
    // A pair of unit length is not cut by this; any other stays in the polynomial's domain.
    let small = small.min(HALF_ROOT);
    let turned = (small.wrapping_mul(COS)).wrapping_sub(large.wrapping_mul(SIN)) as i32 >> 16;
    let angle = (turned.wrapping_mul(ASIN.at(turned.wrapping_mul(turned)))) >> 1;
    let angle = (angle.wrapping_add(1 << 28)).max(0) as u32;
    if sin < cos {
        angle
    } else {
        (1u32 << 30).wrapping_sub(angle)
    }
}
