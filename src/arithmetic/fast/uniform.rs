//! Uniform numbers from one 32-bit word.

use super::coefficients::{TURN_COS, TURN_SIN};
use super::fixed::{leading_30, leading_31};
use crate::arithmetic::native::uniform::f32::{apart, down};
use crate::scalar::{BY_SELECTS, Scalar};

/// A nearer tail and whether it is the upper one: the top bit is the side, the others but for the
/// last give n, and (2n + 1)·2⁻³² is the tail.
///
/// Never 0, at most ½; 2⁻³² is the deepest.
#[inline(always)]
pub(crate) fn tail(bits: u32) -> (f32, bool) {
    (nearer(bits), bits >> 31 != 0)
}

#[inline(always)]
fn nearer(bits: u32) -> f32 {
    down::<33>((bits << 1 | 2) as f32)
}

/// The lower tail n·2⁻³², of n made odd, and the upper one, each rounded once.
#[inline(always)]
pub(crate) fn tails(n: u32) -> [f32; 2] {
    tails_by::<BY_SELECTS>(n)
}

#[inline(always)]
pub(super) fn tails_by<const SELECTS: bool>(n: u32) -> [f32; 2] {
    if SELECTS {
        // What is left of 2³² is odd too.
        let n = n | 1;
        [n, n ^ !1].map(|n| down::<32>(n as f32))
    } else {
        apart(n, nearer)
    }
}

/// (cos, sin) of the azimuth (bits + ½)·2⁻³² turns.
#[inline]
pub(crate) fn turn(bits: u32) -> (f32, f32) {
    let quadrant = bits.wrapping_add(1 << 29) >> 30;
    let rest = (bits << 2 | 2) as i32; // ±2³¹, of 2³⁴ to the turn
    let y = rest >> 16; // eighths of a turn, Q15
    let v = y.wrapping_mul(y) >> 14;
    let cos = leading_30(TURN_COS.at(v), 0);
    let share = TURN_SIN.at(v);
    let sin = rest as f32 * leading_31(share, -32);
    let (cos, sin) = f32::swap_factors_if_odd(quadrant, cos, sin);
    let cos_sign = (quadrant.wrapping_add(1) << 30) & (1 << 31);
    let sin_sign = (quadrant << 30) & (1 << 31);
    (
        f32::from_bits(cos.to_bits() ^ cos_sign),
        f32::from_bits(sin.to_bits() ^ sin_sign),
    )
}
