//! Fixed-point polynomials, and floats put together from integers.

use crate::scalar::BY_SELECTS;

/// A polynomial of x in Q16: the leading coefficient in Qk, the others in Q(k + 16), the inner ones
/// with the half unit that rounds their sum to Qk.
///
/// SSE2 has a product of 16-bit factors, not of 32-bit ones: loops of vectors gain where the
/// compiler sees that 0 ≤ x < ½, and of each sum but the last that it is signed or all its terms
/// are positive.
pub(crate) struct FixedPoint<const N: usize> {
    pub(crate) first: u32,
    pub(crate) inner: [i32; N],
    pub(crate) last: i32,
}

impl<const N: usize> FixedPoint<N> {
    /// The value in Q(k + 16): the last sum keeps all its bits. Wraps for x outside the domain.
    #[inline(always)]
    pub(crate) fn at(&self, x: i32) -> u32 {
        let step = |sum: i32, &c: &i32| sum.wrapping_mul(x).wrapping_add(c) >> 16;
        let sum = self.inner.iter().rev().fold(self.last, step);
        (sum.wrapping_mul(x) as u32).wrapping_add(self.first)
    }
}

/// r·2ᵉ⁻³¹ for 2³¹ ≤ r < 2³², truncated to 24 bits: no conversion and no normalisation.
#[inline(always)]
pub(crate) const fn leading_31(r: u32, e: i32) -> f32 {
    f32::from_bits((r >> 8).wrapping_add(((126 + e) << 23) as u32))
}

/// r·2ᵉ⁻³¹ for 2³⁰ ≤ r ≤ 2³¹; an excess over 2³¹ counts twice, as the carry makes the next power
/// of two.
#[inline(always)]
pub(crate) const fn leading_30(r: u32, e: i32) -> f32 {
    f32::from_bits((r >> 7).wrapping_add(((125 + e) << 23) as u32))
}

/// x in Q`places`, for 0 ≤ x < 2, at most 22 places; some number for any other x.
#[inline(always)]
pub(crate) fn truncated(x: f32, places: u32) -> i32 {
    let bits = x.to_bits();
    let significand = (bits & 0x007F_FFFF) | 0x0080_0000;
    let shift = 150u32.wrapping_sub(places).wrapping_sub(bits >> 23);
    (significand >> shift.min(31)) as i32
}

/// x, or 1 where an error has put x beyond it; NaN as it is.
#[inline(always)]
pub(crate) const fn at_most_one(x: f32) -> f32 {
    if BY_SELECTS {
        // In this form a minimum, which is one instruction.
        return if 1.0 < x { 1.0 } else { x };
    }
    const ONE: u32 = 1.0f32.to_bits();
    let bits = x.to_bits();
    let beyond = bits.wrapping_sub(ONE) <= f32::INFINITY.to_bits() - ONE;
    f32::from_bits(if beyond { ONE } else { bits })
}

/// Σ cᵢ xⁱ in floats.
#[inline(always)]
pub(crate) fn horner<const N: usize>(x: f32, c: &[f32; N]) -> f32 {
    let sum = c.iter().rev().copied().reduce(|sum, k| sum * x + k);
    sum.unwrap_or(0.0)
}
