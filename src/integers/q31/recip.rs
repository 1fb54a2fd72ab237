//! Reciprocals.

use super::coefficients::RECIP;
use crate::integers::kernel::mul::{mul_high, mul_high_signed};

/// 1/(2d) in Q32, of d ≥ ½ in Q32; never above the true value's 1.
///
/// With e = 1 − d r, 1/d = r (1 + e + e² + …); the polynomial leaves e at 2⁻¹⁰, so two terms
/// suffice.
#[inline(always)]
pub(crate) fn half_recip(d: u32) -> u32 {
    let r = RECIP.at(((!d << 1) ^ (1 << 31)) as i32) as u32; // Q14
    let e = (1i32 << 30).wrapping_sub(mul_high(d, r << 16) as i32); // Q30
    let e = e.wrapping_add(((e >> 7).wrapping_mul(e >> 7)) >> 16);
    let more = mul_high_signed((r << 15) as i32, e << 9) >> 5; // Q32 of half the change
    (r << 17).wrapping_add_signed(more.wrapping_sub(2))
}
