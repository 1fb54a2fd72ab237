//! Angles in turns to (cos, sin).

use super::coefficients::{TURN_COS, TURN_SIN};
use crate::integers::kernel::mul::mul_high;
use crate::integers::kernel::poly::Polynomial;
use crate::integers::kernel::{halve, signed};

/// Largest magnitude of a component: 1 less one unit of Q31.
pub(crate) const ONE: u32 = i32::MAX as u32;

/// (cos, sin) in Q31 of x quarter turns, x in Q32; 1 is 2³¹.
///
/// Folded at an eighth, where the two change places: both polynomials stay short.
#[inline(always)]
pub(crate) fn quarter(x: u32) -> (u32, u32) {
    quarter_by(x, &TURN_COS, &TURN_SIN)
}

/// The same by any polynomials, so that a test can spoil one.
#[inline(always)]
pub(crate) fn quarter_by<const A: usize, const B: usize, const C: usize, const D: usize>(
    x: u32,
    cos: &Polynomial<u32, A, B>,
    sin: &Polynomial<u32, C, D>,
) -> (u32, u32) {
    let past = ((x as i32) >> 31) as u32;
    let x = (x ^ past).wrapping_sub(past);
    // An exact eighth is 2³²: taken as one unit less.
    let y = (x << 1).wrapping_sub(x >> 31);
    let square = mul_high(y, y);
    let cos = (1u32 << 31).wrapping_sub(halve(mul_high(square, cos.at(square))));
    let sin = halve(mul_high(y, sin.at(square)));
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
