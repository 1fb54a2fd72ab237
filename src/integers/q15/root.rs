//! Roots and reciprocals.
//!
//! A root of a mantissa m ≥ ½ is 1 − (1 − m) q, where the polynomial q has errors that 1 − m ≤ ½
//! halves.

use super::coefficients::{CBRT, RECIP, SQRT};
use super::word::mul;
use crate::integers::kernel::halve;
use crate::integers::kernel::normal::normal_below;
use crate::integers::kernel::poly::Polynomial;

/// √½ in Q16.
const HALF_ROOT: u32 = 46341;
/// 2^(−1/3) and 2^(−2/3) in Q16.
const THIRD: u32 = 52016;
const TWO_THIRDS: u32 = 41285;

/// 1 − (1 − m) q, for m ≥ 2³¹ in Q32.
#[inline(always)]
pub(crate) fn of_mantissa<const N: usize>(m: u32, q: &Polynomial<u32, N, 0>) -> u32 {
    !(((!m >> 15).wrapping_mul(q.at(m << 1))) >> 1)
}

/// √(m·2⁻ᵒᵈᵈ).
#[inline(always)]
fn sqrt_of(m: u32, odd: u32) -> u32 {
    let root = of_mantissa(m, &SQRT);
    if odd == 0 {
        root
    } else {
        // The half that is cut off, on average.
        (root >> 16)
            .wrapping_mul(HALF_ROOT)
            .wrapping_add(HALF_ROOT >> 1)
    }
}

/// √(x·2⁻ᵉ) in Q32, of x = 0 or ≥ 2^(32 − `LIMIT`) in Q32, e < 2³⁰.
#[inline(always)]
pub(crate) fn scaled<const LIMIT: u32>(x: u32, e: u32) -> u32 {
    if x == 0 {
        return 0;
    }
    let (m, shift) = normal_below::<LIMIT>(x);
    let e = e.wrapping_add(shift);
    sqrt_of(m, e & 1) >> (e >> 1).min(31)
}

/// √x in Q31, of x in Q16.
#[inline(always)]
pub(crate) fn sqrt(x: u32) -> u32 {
    scaled::<16>(x, 0) >> 1
}

/// ⁴√x in Q31 and √x in Q32, of x in Q16.
#[inline(always)]
pub(crate) fn fourth(x: u32) -> (u32, u32) {
    if x == 0 {
        return (0, 0);
    }
    let (m, shift) = normal_below::<16>(x);
    let root = sqrt_of(m, shift & 1);
    let e = shift >> 1;
    (halve(sqrt_of(root, e & 1) >> (e >> 1)), root >> e)
}

/// ∛x in Q32, of x in Q16.
#[inline(always)]
pub(crate) fn cbrt(x: u32) -> u32 {
    if x == 0 {
        return 0;
    }
    let (m, shift) = normal_below::<16>(x);
    let root = of_mantissa(m, &CBRT);
    let third = (shift.wrapping_mul(171)) >> 9;
    let root = match shift.wrapping_sub(third.wrapping_mul(3)) {
        0 => root,
        1 => (root >> 16).wrapping_mul(THIRD).wrapping_add(THIRD >> 1),
        _ => (root >> 16)
            .wrapping_mul(TWO_THIRDS)
            .wrapping_add(TWO_THIRDS >> 1),
    };
    root >> third
}

/// 1/(2d) in Q32, of d ≥ ½ in Q32, whose top bit is not read.
#[inline(always)]
pub(crate) fn half_recip(d: u32) -> u32 {
    let half = RECIP.at(d << 1);
    (half << 16).wrapping_sub(half >> 16)
}

/// 1 − c² in Q32, of c in Q32: exact to 2 units, never 0.
#[inline(always)]
pub(crate) fn less_square(c: u32) -> u32 {
    let (high, low) = (c >> 16, c & 0xFFFF);
    !(mul(c, c).wrapping_add((high.wrapping_mul(low)) >> 15))
}

/// √(v (2 − v)) in Q31, of v = 0 or ≥ 2^(32 − `LIMIT`) in Q32.
#[inline(always)]
pub(crate) fn complement<const LIMIT: u32>(v: u32) -> u32 {
    if v == 0 {
        return 0;
    }
    halve(scaled::<LIMIT>(less_square(!v), 0))
}
