//! Words of 32 bits by their upper halves.

/// Largest magnitude in Q31 that rounds to less than 1 in Q15.
pub(crate) const ONE: u32 = 0x7FFF_7FFF;

/// The product of the upper halves, in Q32.
#[inline(always)]
pub(crate) fn mul(a: u32, b: u32) -> u32 {
    (a >> 16).wrapping_mul(b >> 16)
}

/// x rounded to its upper half, which saturates.
#[inline(always)]
pub(crate) fn rounded(x: u32) -> u32 {
    let half = ((x >> 15).wrapping_add(1)) >> 1;
    half.wrapping_sub(half >> 16)
}
