//! Cube roots. Error in units of 2⁻³¹, exhaustive: 0.9206 (worst word 0x3d480ef7).

use super::coefficients::CBRT;
use crate::integers::kernel::mul::mul_high;
use crate::integers::kernel::normal::normal;

/// 2^(−1/3) and 2^(−2/3) in Q32.
const THIRD: u32 = 3408917802;
const TWO_THIRDS: u32 = 2705659852;

/// ∛(m·2⁻ᵉ) in Q32, of m ≥ 2³¹ in Q32, e < 96.
#[inline(always)]
pub(crate) fn of_mantissa(m: u32, e: u32) -> u32 {
    let t = !m;
    let shape = CBRT.at(((t << 1) ^ (1 << 31)) as i32) as u32;
    let root = !mul_high(t, shape);
    let third = (e.wrapping_mul(171)) >> 9;
    let root = match e.wrapping_sub(third.wrapping_mul(3)) {
        0 => root,
        1 => mul_high(root, THIRD),
        _ => mul_high(root, TWO_THIRDS),
    };
    root >> third.min(31)
}

/// ∛x in Q32, of x in Q32.
#[inline(always)]
pub(crate) fn cbrt(x: u32) -> u32 {
    if x == 0 {
        return 0;
    }
    let (m, shift) = normal(x);
    of_mantissa(m, shift)
}
