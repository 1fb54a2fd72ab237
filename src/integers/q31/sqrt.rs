//! Square and fourth roots.
//!
//! r ≈ 1/√m from a polynomial of degree 3, once improved by Newton's step, gives √m to 16 bits;
//! the exact remainder of its square gives the other 16. Two long products, all others short.
//!
//! Errors in units of 2⁻³¹, exhaustive: √x 0.8333 (worst word 0x7ca48747), ⁴√x 0.9974
//! (0x617930aa).

use super::coefficients::RECIP_SQRT;
use crate::integers::kernel::halve;
use crate::integers::kernel::mul::mul_high;
use crate::integers::kernel::normal::{normal, normal_long};

/// √(m·2⁻³²⁻ᵒᵈᵈ) in Q32, for m ≥ 2³¹ and odd 0 or 1.
#[inline(always)]
fn of_mantissa(m: u32, odd: u32) -> u32 {
    let r = RECIP_SQRT.at((!m) as i32) as u32; // Q14
    // 1 − m r² in Q30.
    let e = (1i32 << 30).wrapping_sub(mul_high(m, (r.wrapping_mul(r)) << 2) as i32);
    let step = ((e >> 5).wrapping_mul(r as i32).wrapping_add(1 << 22)) >> 23;
    let r = (r << 3).wrapping_add_signed(step); // Q17
    let r = r.wrapping_add(
        ((r.wrapping_mul(ROOT_TWO_LESS_ONE).wrapping_add(1 << 14)) >> 15) & odd.wrapping_neg(),
    );
    let (m, lost) = (m >> odd, (m & odd) as i32);
    let s = (mul_high(m, r << 13).wrapping_add(1 << 13)) >> 14; // Q16
    // Both differences are small; s = 2¹⁶ makes its square and its shift wrap, and the sum wraps
    // back.
    let rest = m.wrapping_sub(s.wrapping_mul(s)) as i32;
    let slope = ((r.wrapping_add(1)) >> 1) as i32; // Q16
    let low = (((rest & 3).wrapping_mul(2).wrapping_add(lost)).wrapping_mul(slope)) >> 3;
    // One less than half a unit, so that no root rounds up to 1.
    (s << 16).wrapping_add_signed(
        ((rest >> 2)
            .wrapping_mul(slope)
            .wrapping_add(low)
            .wrapping_add(1 << 14)
            .wrapping_sub(1))
            >> 15,
    )
}

/// √2 − 1 in Q15.
const ROOT_TWO_LESS_ONE: u32 = 13573;

/// √(x·2⁻ᵉ) in Q32, of x in Q32, e < 2³⁰.
#[inline(always)]
pub(crate) fn scaled(x: u32, e: u32) -> u32 {
    if x == 0 {
        return 0;
    }
    let (m, shift) = normal(x);
    let e = e.wrapping_add(shift);
    of_mantissa(m, e & 1) >> (e >> 1).min(31)
}

/// √x in Q31, of x in Q32.
#[inline(always)]
pub(crate) fn sqrt(x: u32) -> u32 {
    halve(scaled(x, 0))
}

/// ⁴√x in Q31, and √x as a normal number (s, e) with √x = s·2⁻ᵉ in Q32, of x in Q32.
#[inline(always)]
pub(crate) fn fourth(x: u32) -> (u32, u32) {
    if x == 0 {
        return (0, 0);
    }
    let (m, shift) = normal(x);
    // The error of one unit must not leave the mantissa's range.
    let root = of_mantissa(m, shift & 1) | (1 << 31);
    let e = shift >> 1;
    (halve(of_mantissa(root, e & 1) >> (e >> 1)), root >> e)
}

/// √(1 − x²) in Q31, for 1 − x = v·2⁻⁶⁴: (1 − x)(1 + x) without a difference that cancels.
#[inline(always)]
pub(crate) fn complement(v: u64) -> u32 {
    if v == 0 {
        return 0;
    }
    let (m, shift) = normal_long(v);
    // m·(1 + x)/2, from 3/8 to 1, so one bit makes it normal again.
    let product = mul_high(m, (!((v >> 32) as u32) >> 1).wrapping_add(1 << 31));
    let less = (product >> 31) ^ 1;
    let e = (shift.wrapping_add(less)).wrapping_sub(1);
    halve(of_mantissa(product << less, e & 1) >> (e >> 1).min(31))
}
