//! Kernels accurate to 16 bits, by products of 16 by 16 bits alone: one instruction each on a Cortex-M0.
//!
//! Arguments and results are the words of 32 bits that the laws work in.

pub(crate) mod angle;
pub(crate) mod kepler;
pub(crate) mod root;
pub(crate) mod table;
pub(crate) mod turn;

#[cfg(test)]
mod tests;

/// Largest magnitude in Q31 that rounds to less than 1 in Q15.
pub(crate) const ONE: u32 = 0x7FFF_7FFF;

/// The product of the upper halves, in Q32.
#[inline(always)]
pub(crate) fn mul(a: u32, b: u32) -> u32 {
    (a >> 16) * (b >> 16)
}

/// x rounded to its upper half, which saturates.
#[inline(always)]
pub(crate) fn rounded(x: u32) -> u32 {
    let half = ((x >> 15) + 1) >> 1;
    half - (half >> 16)
}
