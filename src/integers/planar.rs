//! What the laws in the plane share: θ from −¼ to ¼ turn, symmetric about 0.

use super::drawn::Drawn;
use super::format::Format;
use super::spatial::QUARTER;
use super::tails::Tails;
use crate::CosSin;

/// The nearer tail and a word whose top bit is the sign of θ.
#[inline(always)]
pub(crate) fn nearer(p: Tails) -> (u32, u32) {
    if p.lower < p.upper {
        (p.lower, 1 << 31)
    } else {
        (p.upper, 0)
    }
}

/// Both tails from the nearer one, at θ of the sign of `sign`.
#[inline(always)]
pub(crate) fn tails(nearer: u32, sign: i32) -> Tails {
    if sign < 0 {
        Tails::from_lower(nearer)
    } else {
        Tails::from_upper(nearer)
    }
}

#[inline(always)]
pub(crate) fn pair<F: Format>(cos: u32, sin: u32, sign: u32) -> CosSin<i32> {
    CosSin {
        cos: F::signed(cos, 0),
        sin: F::signed(sin, sign),
    }
}

/// |θ| in turns at a pair with cos θ ≥ 0.
#[inline(always)]
pub(crate) fn turn<F: Format>(at: CosSin<i32>) -> u32 {
    F::first_quadrant(at.cos as u32, at.sin.unsigned_abs())
}

/// |θ| in turns, or the tails outside the support.
#[inline(always)]
pub(crate) fn magnitude(turn: i32) -> Result<u32, Tails> {
    let magnitude = turn.unsigned_abs();
    if magnitude > QUARTER as u32 {
        Err(tails(0, turn))
    } else {
        Ok(magnitude)
    }
}

/// The pair itself where it lies in the support, the tails elsewhere.
#[inline(always)]
pub(crate) fn above(at: CosSin<i32>) -> Result<CosSin<i32>, Tails> {
    if at.cos < 0 {
        Err(tails(0, at.sin))
    } else {
        Ok(at)
    }
}

/// `of` cos θ in Q32 above the horizon, at least one unit; 0 elsewhere.
#[inline(always)]
pub(crate) fn density<F: Format>(cos: i32, of: impl FnOnce(u32) -> u32) -> F::Probability {
    F::probability(if cos <= 0 {
        0
    } else {
        of((cos as u32) << 1).max(F::LEAST)
    })
}

/// `of` cos θ inside the support, 0 outside.
#[inline(always)]
pub(crate) fn pdf<F: Format>(turn: i32, of: impl FnOnce(u32) -> u32) -> F::Probability {
    F::probability(match magnitude(turn) {
        Ok(magnitude) => of((F::cos_sin(magnitude).0 as u32) << 1),
        Err(_) => 0,
    })
}

/// \[sin θ, cos θ\] inside the open support, sin θ with the sign of `sign`'s top bit.
#[inline(always)]
pub(crate) fn direction<F: Format>(cos: u32, sin: u32, sign: u32) -> Drawn<[F::Component; 2]> {
    let at = CosSin {
        cos: F::inside(cos) as i32,
        sin: F::signed(sin, sign),
    };
    Drawn {
        direction: [F::component(at.sin), F::component(at.cos)],
        at,
    }
}
