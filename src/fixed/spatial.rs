//! What the laws in space share: θ from 0 to a quarter turn.

use super::kernel::angle::first_quadrant;
use super::kernel::mul::mul_high;
use super::kernel::turn::{ONE, cos_sin};
use super::law::Tails;
use crate::CosSin;
use ::fixed::types::U0F32;

/// A quarter turn.
pub(crate) const QUARTER: i32 = 1 << 30;

/// Magnitudes in Q31, 1 saturated.
#[inline(always)]
pub(crate) fn pair(cos: u32, sin: u32) -> CosSin<i32> {
    CosSin {
        cos: cos.min(ONE) as i32,
        sin: sin.min(ONE) as i32,
    }
}

/// θ in turns at a pair.
#[inline(always)]
pub(crate) fn turn(at: CosSin<i32>) -> i32 {
    first_quadrant(at.cos as u32, at.sin as u32) as i32
}

/// The pair at θ inside the support, or the tails outside it.
#[inline(always)]
pub(crate) fn at_turn(turn: i32) -> Result<CosSin<i32>, Tails> {
    if turn < 0 {
        Err(Tails::BELOW)
    } else if turn > QUARTER {
        Err(Tails::ABOVE)
    } else {
        let (cos, sin) = cos_sin(turn as u32);
        Ok(CosSin { cos, sin })
    }
}

/// (cos²θ, sin²θ) in Q32, 1 saturated, from the smaller; the tails outside the support.
#[inline(always)]
pub(crate) fn squares(at: CosSin<i32>) -> Result<(u32, u32), Tails> {
    if at.sin < 0 {
        return Err(Tails::BELOW);
    }
    if at.cos < 0 {
        return Err(Tails::ABOVE);
    }
    let (cos, sin) = ((at.cos as u32) << 1, (at.sin as u32) << 1);
    Ok(if sin < cos {
        let square = mul_high(sin, sin);
        (!square, square)
    } else {
        let square = mul_high(cos, cos);
        (square, !square)
    })
}

/// `of` cos θ in Q32 in the support, at least one unit inside it; 0 outside.
#[inline(always)]
pub(crate) fn density(at: CosSin<i32>, of: impl FnOnce(u32) -> u32) -> U0F32 {
    U0F32::from_bits(if at.sin < 0 || at.cos <= 0 {
        0
    } else {
        of((at.cos as u32) << 1).max(1)
    })
}

/// `of` cos θ, times sin θ.
#[inline(always)]
pub(crate) fn pdf(turn: i32, of: impl FnOnce(u32) -> u32) -> U0F32 {
    U0F32::from_bits(match at_turn(turn) {
        Ok(at) => mul_high(of((at.cos as u32) << 1), (at.sin as u32) << 1),
        Err(_) => 0,
    })
}
