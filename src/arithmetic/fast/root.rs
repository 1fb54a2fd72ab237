//! Cube and fourth roots: the exponent divided, the significand by an integer polynomial of degree
//! 4.

use super::coefficients::{CBRT, FOURTH_ROOT};
use super::fixed::FixedPoint;
use crate::arithmetic::native::sqrt::unusual;

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
/// No root of a number up to 1 is above 1.
#[inline(always)]
fn assemble<const N: usize>(bits: u32, shape: &FixedPoint<N>, part: u32, e: u32) -> f32 {
    const ONE: u32 = 1.0f32.to_bits();
    let f = (bits >> 7) & 0xFFFF;
    let root = shape.at(f as i32).wrapping_add(0x8000) >> 16;
    let significand = root.wrapping_mul(part) >> 7;
    let root = significand.wrapping_add(e.wrapping_sub(1) << 23);
    f32::from_bits(if bits <= ONE && root > ONE { ONE } else { root })
}

/// ∛x for x ≥ 0; ±0 and +∞ as they are, NaN below 0.
#[inline]
pub(crate) fn cbrt(x: f32) -> f32 {
    let bits = x.to_bits();
    if unusual(bits) {
        return of_unusual(x, cbrt, 1.0 / 256.0);
    }
    let n = (bits >> 23).wrapping_add(254);
    let third = n.wrapping_mul(171) >> 9; // n / 3 for n ≤ 509
    let rest = n.wrapping_sub(third.wrapping_mul(3));
    // 2^(0, 1/3, 2/3) in Q15.
    let slope = rest.wrapping_mul(1107).wrapping_add(7410);
    let part = rest.wrapping_mul(slope).wrapping_add(32768);
    assemble(bits, &CBRT, part, third)
}

/// ⁴√x; ±0 and +∞ as they are, NaN below 0. One pass, so half the cost and the error of two square
/// roots.
#[inline]
pub(crate) fn fourth_root(x: f32) -> f32 {
    let bits = x.to_bits();
    if unusual(bits) {
        return of_unusual(x, fourth_root, 1.0 / 64.0);
    }
    let n = (bits >> 23).wrapping_add(381);
    let rest = n & 3;
    // 2^(0, 1/4, 1/2, 3/4) in Q15.
    let bend = rest.wrapping_mul(74).wrapping_add(951);
    let slope = rest.wrapping_mul(bend).wrapping_add(11375);
    let part = (rest.wrapping_mul(slope) >> 1).wrapping_add(32768);
    assemble(bits, &FOURTH_ROOT, part, n >> 2)
}
