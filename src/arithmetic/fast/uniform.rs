//! Uniform numbers from one 32-bit word.

use super::coefficients::{TURN_COS, TURN_SIN};
use super::fixed::{leading_30, leading_31};
use super::root::BY_SELECTS;
use crate::arithmetic::native::uniform::f32::down;
use crate::scalar::Scalar;

/// A nearer tail and whether it is the upper one: the top bit is the side, the others but for the
/// last give n, and (2n + 1)·2⁻³² is the tail.
///
/// Never 0, at most ½; 2⁻³² is the deepest.
#[inline(always)]
pub(crate) fn tail(bits: u32) -> (f32, bool) {
    (down::<33>((bits << 1 | 2) as f32), bits >> 31 != 0)
}

/// Both tails of the same word, the lower first, each rounded once.
#[inline(always)]
pub(crate) fn tails(bits: u32) -> [f32; 2] {
    tails_by::<BY_SELECTS>(bits)
}

#[inline(always)]
pub(super) fn tails_by<const SELECTS: bool>(bits: u32) -> [f32; 2] {
    if SELECTS {
        // The word in the order of the lower tails, which counts them whatever their side. Odd, so
        // that what is left of 2³² is odd too.
        let n = bits ^ ((bits as i32 >> 31) as u32 >> 1) | 1;
        return [n, n ^ !1].map(|n| down::<32>(n as f32));
    }
    // The farther is put together from its bits, since a difference may be a routine.
    let ((p, _), q) = (tail(bits), far_tail(bits << 1 >> 1));
    if bits >> 31 != 0 { [q, p] } else { [p, q] }
}

/// 1 − n·2⁻³² for odd n < 2³¹, rounded: half a place is added and cut off, since an odd n leaves no
/// tie.
#[inline(always)]
fn far_tail(n: u32) -> f32 {
    let halves = (1 << 24) - (n >> 7);
    f32::from_bits((halves >> 1) + 0.5f32.to_bits())
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
