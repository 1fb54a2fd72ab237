//! The square root of an `f32` in 32-bit integers, for processors with no instruction for it: the
//! same bits, since IEEE 754 rounds a root once.
//!
//! Method: ρ ≈ 1/√X by a polynomial (2⁻¹³·⁷), of which t = Xρ is a root of 15 bits and t + (X −
//! t²)ρ/2 one within ±0.4 of the last place. Cut off, that is the root or one less: the sign of
//! X − r² − r, of which 32 bits are enough, tells which. No root is a tie.
//!
//! Error: none. Shown on every significand of either parity and every subnormal number.

use super::coefficients_sqrt::RECIP_SQRT;

/// Not normal and positive: subnormal, ±0, ∞, NaN, or negative.
#[inline(always)]
pub(crate) const fn unusual(bits: u32) -> bool {
    const LEAST: u32 = f32::MIN_POSITIVE.to_bits();
    bits.wrapping_sub(LEAST) >= f32::INFINITY.to_bits() - LEAST
}

/// ±0 and +∞ as they are, NaN below 0.
#[cold]
fn of_unusual(x: f32) -> f32 {
    if x < 0.0 {
        f32::NAN
    } else if x > 0.0 && x < f32::MIN_POSITIVE {
        sqrt(x * 16_777_216.0) * (1.0 / 4096.0)
    } else {
        x
    }
}

/// √x.
#[inline]
pub(crate) fn sqrt(x: f32) -> f32 {
    /// Centres the error: half of a step's square is always lost.
    const CENTRE: i32 = 96;
    let bits = x.to_bits();
    if unusual(bits) {
        return of_unusual(x);
    }
    // X from 2³⁰ to 2³², its exponent even; ρ = 2¹⁵/√X in Q16.
    let odd = (bits >> 23) & 1;
    let square = ((bits << 8) | 1 << 31) >> odd;
    let reciprocal = RECIP_SQRT.at(((bits << 9) >> 16) as i32) >> 16;
    // 2^(16, 15½)
    let part = 19193u32.wrapping_mul(odd).wrapping_add(46343);
    let reciprocal = reciprocal.wrapping_mul(part) >> 15;
    let root = (square >> 16).wrapping_mul(reciprocal) >> 15;
    let rest = square.wrapping_sub(root.wrapping_mul(root)) as i32;
    let step = (rest.wrapping_add(CENTRE) >> 5).wrapping_mul(reciprocal as i32) >> 19;
    let root = (root << 8).wrapping_add(step as u32);
    // X·2¹⁶ − r² is small, so that 32 bits hold it.
    let rest = (square << 16).wrapping_sub(root.wrapping_mul(root));
    let up = root.wrapping_sub(rest) >> 31;
    // The root's leading one counts as one in the exponent.
    let exponent = (bits >> 23).wrapping_add(125) >> 1 << 23;
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
