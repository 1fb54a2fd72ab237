//! The cube root: the exponent divided, the significand by an integer polynomial of degree 4.

use super::coefficients::CBRT;
use crate::arithmetic::native::sqrt::unusual;
use crate::scalar::Scalar;

/// 2²⁴: makes a subnormal number normal.
pub(crate) const UP: f32 = 16_777_216.0;

/// Whether rare cases are selected, as loops of vectors need, not branched to: on 32-bit processors
/// a product may be a routine. Always the same bits.
pub(crate) const BY_SELECTS: bool = cfg!(target_pointer_width = "64");

/// `a` if `first`, else `b`: by a mask, with both at hand, or by a branch.
#[inline(always)]
pub(crate) fn choose<const SELECTS: bool>(
    first: bool,
    a: impl FnOnce() -> f32,
    b: impl FnOnce() -> f32,
) -> f32 {
    if SELECTS {
        f32::select(first, a(), b())
    } else if first {
        a()
    } else {
        b()
    }
}

/// ∛x for finite x > 0, any other x as it is. Of no number up to 1 it is above 1.
#[inline]
pub(crate) fn cbrt(x: f32) -> f32 {
    const LEAST: u32 = f32::MIN_POSITIVE.to_bits();
    const POSITIVE: u32 = f32::INFINITY.to_bits() - 1;
    let bits = x.to_bits();
    if BY_SELECTS {
        let up = if x < f32::MIN_POSITIVE { x * UP } else { x };
        let less = (bits.wrapping_sub(LEAST) as i32 >> 31) as u32 & 24;
        let root = of_normal(up.to_bits(), 251u32.wrapping_sub(less));
        f32::from_bits(if bits.wrapping_sub(1) < POSITIVE {
            root
        } else {
            bits
        })
    } else if unusual(bits) {
        of_unusual(x)
    } else {
        f32::from_bits(of_normal(bits, 251))
    }
}

#[cold]
fn of_unusual(x: f32) -> f32 {
    if x > 0.0 && x < f32::MIN_POSITIVE {
        f32::from_bits(of_normal((x * UP).to_bits(), 227))
    } else {
        x
    }
}

/// Of the pattern of a normal number; some number of others. `bias` is twice the exponent's, less 3
/// and what the number was scaled up by.
///
/// Vectors multiply factors of 16 bits, and such they are.
#[inline(always)]
fn of_normal(bits: u32, bias: u32) -> u32 {
    // n / 3 in Q16, for n ≤ 511
    let thirds = (bits >> 23).wrapping_add(bias).wrapping_mul(21846);
    let (third, rest) = (thirds >> 16, (thirds >> 14) & 3);
    // 2^(0, 1/3, 2/3) in Q16.
    let part = rest.wrapping_mul(rest.wrapping_mul(2214).wrapping_add(14820));
    let part = part.wrapping_add(1 << 16);
    // That of 1 + f, f from the significand, less 1.
    let half = (bits >> 8) & 0x7FFF;
    let more = CBRT.at(half as i32).wrapping_sub(1 << 31) >> 15;
    let product = (part >> 2).wrapping_mul(more) >> 7;
    (third << 23).wrapping_add(part << 7).wrapping_add(product)
}
