//! The square root of an `f32` in 32-bit integers, for processors with no instruction for it: the
//! same bits, since IEEE 754 rounds a root once.
//!
//! Method: ρ ≈ 1/√X by a polynomial (2⁻¹³·⁷), of which t = Xρ is a root of 15 bits, and
//! t + (X − t²)ρ/2 one that is off by −0.36 to 0.02 of the last place. Cut off, that is the root or
//! one less: the sign of X − r² − r, of which 32 bits are enough, tells which. No root is a tie.
//!
//! Error: none. Shown on every significand of either parity, every exponent and every subnormal
//! number.

use super::coefficients_f32::RECIPROCAL_ROOT;

/// Not normal and positive: subnormal, ±0, ∞, NaN, or negative.
#[inline(always)]
pub(crate) const fn unusual(bits: u32) -> bool {
    const LEAST: u32 = f32::MIN_POSITIVE.to_bits();
    bits.wrapping_sub(LEAST) >= f32::INFINITY.to_bits() - LEAST
}

/// √x; ±0 and +∞ as they are, NaN below 0.
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    let mut bits = x.to_bits();
    let mut exponent = bits >> 23;
    if unusual(bits) {
        if x < 0.0 {
            return f32::NAN;
        }
        if bits << 1 == 0 || exponent != 0 {
            return x;
        }
        // No call of a product, for which each caller would save registers.
        let shift = bits.leading_zeros().wrapping_sub(8);
        bits = bits.wrapping_shl(shift);
        exponent = 1u32.wrapping_sub(shift);
    }
    // X from 2³⁰ to 2³², its exponent even; ρ = 2¹⁵/√X in Q16.
    let odd = exponent & 1;
    let square = ((bits << 8) | 1 << 31) >> odd;
    let x = ((bits << 9) >> 16) as i32;
    let [c0, c1, c2, c3, c4] = RECIPROCAL_ROOT;
    let step = |sum: i32, c: i32| (sum.wrapping_mul(x) >> 16).wrapping_add(c);
    let reciprocal = step(step(step(step(c4, c3), c2), c1), c0) as u32;
    // 2^(15, 14½)
    let part = 9597u32.wrapping_mul(odd).wrapping_add(23171);
    let reciprocal = reciprocal.wrapping_mul(part) >> 15;
    let root = (square >> 16).wrapping_mul(reciprocal) >> 15;
    let rest = square.wrapping_sub(root.wrapping_mul(root)) as i32;
    let step = (rest >> 5).wrapping_mul(reciprocal as i32) >> 19;
    let root = (root << 8).wrapping_add(step as u32);
    // X·2¹⁶ − r² is small, so that 32 bits hold it.
    let rest = (square << 16).wrapping_sub(root.wrapping_mul(root));
    let up = root.wrapping_sub(rest) >> 31;
    // The root's leading one counts as one in the exponent.
    let exponent = exponent.wrapping_add(125) >> 1 << 23;
    f32::from_bits(exponent.wrapping_add(root).wrapping_add(up))
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::sqrt;

    fn same(bits: u32) {
        let x = f32::from_bits(bits);
        assert_eq!(sqrt(x).to_bits(), x.sqrt().to_bits(), "{bits:#010x}");
    }

    /// Both parities of the exponent; the others shift the result alone.
    #[test]
    fn every_significand_as_the_instruction() {
        (1.0f32.to_bits()..4.0f32.to_bits()).for_each(same);
    }

    #[test]
    fn every_exponent_and_subnormal_number_as_the_instruction() {
        let edges = (1..255).flat_map(|e| [0u32, 1, 0x40_0000, 0x7F_FFFF].map(|m| e << 23 | m));
        edges.for_each(same);
        (0..f32::MIN_POSITIVE.to_bits()).for_each(same);
        for x in [f32::INFINITY, -0.0f32] {
            same(x.to_bits());
        }
        for nan in [f32::NAN, -f32::MIN_POSITIVE, -1e-45, f32::NEG_INFINITY] {
            assert!(sqrt(nan).is_nan(), "{nan:e}");
        }
    }
}
