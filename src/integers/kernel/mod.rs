//! What both formats' kernels are made of: u32 words as Q31 or Q32, long products counted since a
//! Cortex-M0 pays sixteen instructions for each.

pub(crate) mod mul;
pub(crate) mod normal;
pub(crate) mod poly;

/// Q32 to the nearest of Q31.
#[inline(always)]
pub(crate) fn halve(x: u32) -> u32 {
    (x >> 1).wrapping_add(x & 1)
}

/// `magnitude` ≤ 2³¹ with the sign of `sign`'s top bit, 1 saturated.
#[inline(always)]
pub(crate) fn signed(magnitude: u32, sign: u32) -> i32 {
    let mask = (sign as i32) >> 31;
    ((magnitude.wrapping_sub(magnitude >> 31)) as i32 ^ mask).wrapping_sub(mask)
}
