//! What the laws in space share: θ from 0 to a quarter turn.

use super::format::Format;
use super::kernel::normal::normal;
use super::tails::Tails;
use crate::CosSin;

/// A quarter turn.
pub(crate) const QUARTER: i32 = 1 << 30;

/// Magnitudes in Q31, 1 saturated.
#[inline(always)]
pub(crate) fn pair<F: Format>(cos: u32, sin: u32) -> CosSin<i32> {
    CosSin {
        cos: F::saturated(cos) as i32,
        sin: F::saturated(sin) as i32,
    }
}

/// θ in turns at a pair.
#[inline(always)]
pub(crate) fn turn<F: Format>(at: CosSin<i32>) -> i32 {
    F::first_quadrant(at.cos as u32, at.sin as u32) as i32
}

/// The pair at θ inside the support, or the tails outside it.
#[inline(always)]
pub(crate) fn at_turn<F: Format>(turn: i32) -> Result<CosSin<i32>, Tails> {
    if turn < 0 {
        Err(Tails::BELOW)
    } else if turn > QUARTER {
        Err(Tails::ABOVE)
    } else {
        let (cos, sin) = F::cos_sin(turn as u32);
        Ok(CosSin { cos, sin })
    }
}

/// (cos²θ, sin²θ) in Q32, 1 saturated, from the smaller; the tails outside the support.
#[inline(always)]
pub(crate) fn squares<F: Format>(at: CosSin<i32>) -> Result<(u32, u32), Tails> {
    if at.sin < 0 {
        return Err(Tails::BELOW);
    }
    if at.cos < 0 {
        return Err(Tails::ABOVE);
    }
    let (cos, sin) = ((at.cos as u32) << 1, (at.sin as u32) << 1);
    Ok(if sin < cos {
        let square = F::mul(sin, sin);
        (!square, square)
    } else {
        let square = F::mul(cos, cos);
        (square, !square)
    })
}

/// `of` cos θ in Q32 in the support, at least one unit inside it; 0 outside.
#[inline(always)]
pub(crate) fn density<F: Format>(at: CosSin<i32>, of: impl FnOnce(u32) -> u32) -> F::Probability {
    F::probability(if at.sin < 0 || at.cos <= 0 {
        0
    } else {
        of((at.cos as u32) << 1).max(F::LEAST)
    })
}

/// `of` cos θ, times sin θ.
#[inline(always)]
pub(crate) fn pdf<F: Format>(turn: i32, of: impl FnOnce(u32) -> u32) -> F::Probability {
    F::probability(match at_turn::<F>(turn) {
        Ok(at) => F::mul(of((at.cos as u32) << 1), (at.sin as u32) << 1),
        Err(_) => 0,
    })
}

/// √½ in Q32.
const HALF_ROOT: u32 = 3037000500;

/// (√(x² + z²), the angle of (x, z) in turns, which wraps) of components in Q31; (0, 0) at 0.
#[inline(always)]
pub(crate) fn polar<F: Format>(x: i32, z: i32) -> (i32, u32) {
    let [a, b] = [x, z].map(|c| c.unsigned_abs().min(i32::MAX as u32));
    if a | b == 0 {
        return (0, 0);
    }
    // Both up by as much as the larger one allows, in Q32; then the root of half their squares'
    // sum.
    let (_, shift) = normal(a | b);
    let [a, b] = [a, b].map(|c| c.wrapping_shl(shift));
    let root = F::scaled((F::mul(a, a) >> 1).wrapping_add(F::mul(b, b) >> 1), 0);
    let sin = F::mul(root, HALF_ROOT).wrapping_shr(shift.wrapping_sub(1));
    let (d, up) = normal(root);
    let recip = F::half_recip(d);
    let unit = |c: u32| {
        let part = F::mul(F::mul(c, recip), HALF_ROOT);
        part.min(u32::MAX.wrapping_shr(up.wrapping_add(1)))
            .wrapping_shl(up)
    };
    let turn = F::first_quadrant(unit(a), unit(b));
    let turn = if x < 0 {
        (1u32 << 31).wrapping_sub(turn)
    } else {
        turn
    };
    let turn = if z < 0 { turn.wrapping_neg() } else { turn };
    (sin.min(i32::MAX as u32) as i32, turn)
}
