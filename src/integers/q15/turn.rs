//! Angles in turns to (cos, sin).

use super::coefficients::{TURN_COS, TURN_SIN};
use crate::integers::kernel::poly::Polynomial;
use crate::integers::kernel::signed;

/// (cos, sin) in Q31 of y eighths of a turn, y in Q16 below 1; both are below 1.
#[inline(always)]
pub(crate) fn eighth(y: u32) -> (u32, u32) {
    eighth_by(y, &TURN_COS, &TURN_SIN)
}

/// The same by any polynomials, so that a test can spoil one.
#[inline(always)]
pub(crate) fn eighth_by<const A: usize, const B: usize>(
    y: u32,
    cos: &Polynomial<u32, A, 0>,
    sin: &Polynomial<u32, B, 0>,
) -> (u32, u32) {
    let square = y.wrapping_mul(y);
    (
        (i32::MAX as u32).wrapping_sub(((square >> 16).wrapping_mul(cos.at(square))) >> 2),
        (y.wrapping_mul(sin.at(square))) >> 1,
    )
}

/// (cos, sin) in Q31 of x quarter turns, x in Q32.
#[inline(always)]
pub(crate) fn quarter(x: u32) -> (u32, u32) {
    let past = ((x as i32) >> 31) as u32;
    let x = (x ^ past).wrapping_sub(past);
    // An exact eighth is 2³²: taken as one unit less.
    let (cos, sin) = eighth((x.wrapping_sub(x >> 31)) >> 15);
    let swap = (cos ^ sin) & past;
    (cos ^ swap, sin ^ swap)
}

/// (cos, sin) in Q31 of `phase`·2⁻³² turns; ±1 saturate to ±(1 − 2⁻³¹).
#[inline(always)]
pub(crate) fn cos_sin(phase: u32) -> (i32, i32) {
    let (cos, sin) = quarter(phase << 2);
    let swap = (cos ^ sin) & (((phase << 1) as i32) >> 31) as u32;
    (
        signed(cos ^ swap, phase ^ (phase << 1)),
        signed(sin ^ swap, phase),
    )
}
