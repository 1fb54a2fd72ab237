//! Square, cube and fourth roots: the exponent divided, the significand by an integer polynomial
//! of degree 4.
//!
//! A square root of the format is one instruction where there is one, but about 415 on a Cortex-M0 and
//! 51 (`libm`'s) on a Cortex-M4F: there integers give the same bits in fewer.

use super::coefficients::{CBRT, SQRT};
use super::fixed::FixedPoint;
use crate::scalar::Scalar;

/// Not normal and positive: subnormal, ±0, ∞, NaN, or negative.
#[inline(always)]
pub(crate) const fn unusual(bits: u32) -> bool {
    const LEAST: u32 = f32::MIN_POSITIVE.to_bits();
    bits.wrapping_sub(LEAST) >= f32::INFINITY.to_bits() - LEAST
}

/// 2²⁴: makes a subnormal number normal.
pub(crate) const UP: f32 = 16_777_216.0;

/// `down` is `root`(2⁻²⁴).
#[cold]
fn of_unusual(x: f32, root: fn(f32) -> f32, down: f32) -> f32 {
    if x < 0.0 {
        f32::NAN
    } else if x > 0.0 && x < f32::MIN_POSITIVE {
        root(x * UP) * down
    } else {
        x
    }
}

/// The root of 1 + f times `part` (Q15), with the biased exponent `e`; f from the significand of
/// `bits`.
#[inline(always)]
fn assemble<const N: usize>(bits: u32, shape: &FixedPoint<N>, part: u32, e: u32) -> f32 {
    let f = (bits >> 7) & 0xFFFF;
    let root = shape.at(f as i32).wrapping_add(0x8000) >> 16;
    let significand = root.wrapping_mul(part) >> 7;
    f32::from_bits(significand.wrapping_add(e.wrapping_sub(1) << 23))
}

/// Whether a square root of the format is an instruction that this crate reaches.
const INSTRUCTION: bool = cfg!(any(
    feature = "std",
    target_arch = "x86_64",
    target_arch = "aarch64"
));

/// √x to 13 bits: the format's root, rounded once more, half up. So few bits can be had from
/// integers at little cost, and are the same. ±0 and +∞ as they are, NaN below 0.
#[inline(always)]
pub(crate) fn sqrt(x: f32) -> f32 {
    if INSTRUCTION {
        by_instruction(x)
    } else {
        by_integers(x)
    }
}

/// [`sqrt`] from the format's own.
#[inline(always)]
fn by_instruction(x: f32) -> f32 {
    f32::from_bits(Scalar::sqrt(x).to_bits().wrapping_add(0x400) & !0x7FF)
}

/// [`sqrt`] by integers alone: a polynomial, and one product that says whether it is one too many.
#[inline]
fn by_integers(x: f32) -> f32 {
    let bits = x.to_bits();
    if unusual(bits) {
        return of_unusual(x, by_integers, 1.0 / 4096.0);
    }
    let n = (bits >> 23) + 127;
    let odd = n & 1;
    let part = 32768 + 13573 * odd; // 2^(0, 1/2) in Q15
    let shape = SQRT.at(((bits >> 7) & 0xFFFF) as i32).wrapping_add(0x8000) >> 16;
    // The polynomial and its roundings are off by less than 0.4 units of 2⁻¹²: half a unit and as much
    // more make it the nearest or the next.
    let root = shape.wrapping_mul(part).wrapping_add(235_000) >> 18;
    // It is the nearest if the format's root reaches its middle, Q of 2⁻¹³, at most half a last place
    // below: from Q² − Q·2⁻¹⁰ on.
    let middle = root.wrapping_mul(2).wrapping_sub(1);
    let reach = middle
        .wrapping_mul(middle)
        .wrapping_sub(middle.wrapping_sub(1) >> 10);
    let square = ((bits & 0x007F_FFFF) | 0x0080_0000) << (3 + odd);
    let root = root.wrapping_sub(u32::from(square < reach));
    f32::from_bits((root << 11).wrapping_add((n >> 1).wrapping_sub(1) << 23))
}

/// ∛x for x ≥ 0; ±0 and +∞ as they are, NaN below 0.
#[inline]
pub(crate) fn cbrt(x: f32) -> f32 {
    let bits = x.to_bits();
    if unusual(bits) {
        return of_unusual(x, cbrt, 1.0 / 256.0);
    }
    let n = (bits >> 23) + 254;
    let third = (n * 171) >> 9; // n / 3 for n ≤ 509
    let rest = n.wrapping_sub(3 * third) & 3;
    let part = 32768 + rest * (7410 + 1107 * rest); // 2^(0, 1/3, 2/3) in Q15
    assemble(bits, &CBRT, part, third)
}

#[cfg(test)]
mod tests {
    use super::{by_instruction, by_integers};

    /// Both of the root's ways at x.
    fn alike(bits: u32) {
        let x = f32::from_bits(bits);
        let (a, b) = (by_instruction(x), by_integers(x));
        assert!(
            a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()),
            "{bits:#x}: {a:e} and {b:e}"
        );
    }

    /// Every significand at an even and an odd exponent; other exponents do not enter.
    #[test]
    fn integers_give_the_bits_of_the_instruction() {
        (0x3f80_0000..0x4080_0000).for_each(alike);
        (0..0x7f80_0001).step_by(1009).for_each(alike);
        (0x8000_0000..u32::MAX).step_by(100_003).for_each(alike);
    }
}
