//! The cube root: the exponent divided, the significand by an integer polynomial of degree 4.

use super::coefficients::CBRT;
use crate::arithmetic::native::sqrt::unusual;

/// 2²⁴: makes a subnormal number normal.
pub(crate) const UP: f32 = 16_777_216.0;

#[cold]
fn of_unusual(x: f32) -> f32 {
    if x < 0.0 {
        f32::NAN
    } else if x > 0.0 && x < f32::MIN_POSITIVE {
        cbrt(x * UP) * (1.0 / 256.0)
    } else {
        x
    }
}

/// ∛x for x ≥ 0; ±0 and +∞ as they are, NaN below 0. Of no number up to 1 it is above 1.
#[inline]
pub(crate) fn cbrt(x: f32) -> f32 {
    const ONE: u32 = 1.0f32.to_bits();
    let bits = x.to_bits();
    if unusual(bits) {
        return of_unusual(x);
    }
    let n = (bits >> 23).wrapping_add(254);
    let third = n.wrapping_mul(171) >> 9; // n / 3 for n ≤ 509
    let rest = n.wrapping_sub(third.wrapping_mul(3));
    // 2^(0, 1/3, 2/3) in Q15.
    let slope = rest.wrapping_mul(1107).wrapping_add(7410);
    let part = rest.wrapping_mul(slope).wrapping_add(32768);
    // That of 1 + f, f from the significand.
    let f = (bits >> 7) & 0xFFFF;
    let root = CBRT.at(f as i32).wrapping_add(0x8000) >> 16;
    let significand = root.wrapping_mul(part) >> 7;
    let root = significand.wrapping_add(third.wrapping_sub(1) << 23);
    f32::from_bits(if bits <= ONE && root > ONE { ONE } else { root })
}
