//! Uniform numbers from one 32-bit word.

use super::coefficients::{TURN_COS, TURN_SIN};
use super::fixed::{leading_30, leading_31};
use super::root::BY_SELECTS;
use crate::arithmetic::native::turn::merge_if_odd;
use crate::arithmetic::native::uniform::f32::{tail_of_half, whole};

/// A nearer tail and whether it is the upper one: the top bit is the side, the others n give (2n +
/// 1)·2⁻³³.
///
/// Never 0, at most ½; 2⁻³³ is the deepest.
#[inline(always)]
pub(crate) fn tail(bits: u32) -> (f32, bool) {
    (tail_of_half(bits), bits >> 31 != 0)
}

/// Both tails of the same word, the lower first, each rounded once.
#[inline(always)]
pub(crate) fn tails(bits: u32) -> [f32; 2] {
    tails_by::<BY_SELECTS>(bits)
}

#[inline(always)]
pub(super) fn tails_by<const SELECTS: bool>(bits: u32) -> [f32; 2] {
    if SELECTS {
        // The word in the order of the lower tails, which counts them whatever their side.
        let n = bits ^ ((bits as i32 >> 31) as u32 >> 1);
        return [whole(n), whole(!n)];
    }
    // The farther is put together from its bits, since a difference may be a routine.
    let (p, q) = (tail_of_half(bits), far_tail(bits << 1 >> 1));
    if bits >> 31 != 0 { [q, p] } else { [p, q] }
}

/// 1 − (n + ½)·2⁻³² for n < 2³¹, rounded: half a place is added and cut off, since the half of a
/// unit leaves no tie.
#[inline(always)]
fn far_tail(n: u32) -> f32 {
    let halves = (1 << 24) - (n >> 7);
    f32::from_bits((halves >> 1) + 0.5f32.to_bits())
}

/// (cos, sin) of the azimuth (bits + ½)·2⁻³² turns.
#[inline]
pub(crate) fn turn(bits: u32) -> (f32, f32) {
    let quadrant = bits.wrapping_add(1 << 29) >> 30;
    let rest = (bits << 2) as i32; // ±2³¹, of 2³⁴ to the turn
    let y = rest >> 16; // eighths of a turn, Q15
    let v = y.wrapping_mul(y) >> 14;
    let cos = leading_30(TURN_COS.at(v), 0).to_bits();
    let share = TURN_SIN.at(v);
    let sin = ((rest >> 1 | 1) as f32 * leading_31(share, -31)).to_bits();
    let (cos, sin) = if BY_SELECTS {
        // In half the instructions of masks: both are integers here.
        let odd = quadrant & 1 != 0;
        (if odd { sin } else { cos }, if odd { cos } else { sin })
    } else {
        merge_if_odd(quadrant, cos, sin)
    };
    let cos_sign = (quadrant.wrapping_add(1) << 30) & (1 << 31);
    let sin_sign = (quadrant << 30) & (1 << 31);
    (
        f32::from_bits(cos ^ cos_sign),
        f32::from_bits(sin ^ sin_sign),
    )
}
