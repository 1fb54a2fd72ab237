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
    const POSITIVE: u32 = f32::INFINITY.to_bits() - 1;
    let bits = x.to_bits();
    if BY_SELECTS {
        let factor = f32::select(x < f32::MIN_POSITIVE, UP, 1.0);
        let up = (x * factor).to_bits();
        let n = up
            .wrapping_sub(factor.to_bits())
            .wrapping_add((BIAS + 127) << 23)
            >> 23;
        let root = of_normal(up, n);
        f32::from_bits(if bits.wrapping_sub(1) < POSITIVE {
            root
        } else {
            bits
        })
    } else if unusual(bits) {
        of_unusual(x)
    } else {
        f32::from_bits(of_normal(bits, (bits >> 23).wrapping_add(BIAS)))
    }
}

#[cold]
fn of_unusual(x: f32) -> f32 {
    if x > 0.0 && x < f32::MIN_POSITIVE {
        let up = (x * UP).to_bits();
        f32::from_bits(of_normal(up, (up >> 23).wrapping_add(BIAS - 24)))
    } else {
        x
    }
}

/// n of the greatest power of two not above 1 is 3·127 − 3 more than its exponent.
const BIAS: u32 = 251;

/// ∛2, so that the root of 1 is 1 and that of no number below it is more.
const PART_Q14: u32 = 20642;
const PART_Q23: u32 = 10_568_920;

/// Of the pattern of a normal number, n its exponent and [`BIAS`]; some number of others.
///
/// 2(1 − x) is the significand, and all products are of 16 bits.
#[inline(always)]
fn of_normal(bits: u32, n: u32) -> u32 {
    // n / 3 in Q16, for n ≤ 511
    let thirds = n.wrapping_mul(21846);
    let rest = (thirds >> 14) & 3;
    // 2^(1/3, 2/3, 1) in Q16, less the first
    let more = rest.wrapping_mul(rest.wrapping_mul(2789).wrapping_add(18673));
    let part = (more >> 2).wrapping_add(PART_Q14);
    let x = !(bits >> 8) & 0x7FFF;
    let less = CBRT.at(x as i32) as i32 >> 16;
    let product = (part as i32).wrapping_mul(less) >> 7;
    let root = (thirds & 0xFFFF_0000).wrapping_add(more) << 7;
    root.wrapping_add(PART_Q23).wrapping_add(product as u32)
}
