//! Logarithms and exponentials.
//!
//! cosᵏθ = exp(k ln cos θ) multiplies the relative error of ln cos θ by k |ln cos θ| (87 where
//! cosᵏθ underflows), so the logarithm has 2⁻²⁰·⁷, eight bits more than the result needs.

use super::coefficients::{EXP2, EXP2_M1, LN};
use super::fixed::{horner, leading_31};
use super::root::UP;
use crate::arithmetic::native::sqrt::unusual;
use core::f32::consts::{FRAC_1_SQRT_2, LN_2, LOG2_E};

/// (m, e) with x = m·2ᵉ, m from √½ to √2, for normal x > 0.
#[inline(always)]
fn split(bits: u32) -> (f32, i32) {
    let e = (bits.wrapping_sub(FRAC_1_SQRT_2.to_bits()) as i32) >> 23;
    (f32::from_bits(bits.wrapping_sub((e << 23) as u32)), e)
}

/// e ln 2 + 2 atanh z.
#[inline(always)]
fn sum(z: f32, e: i32) -> f32 {
    z * horner(z * z, &LN) + e as f32 * LN_2
}

#[cold]
fn ln_of_unusual(x: f32) -> f32 {
    if x == 0.0 {
        f32::NEG_INFINITY
    } else if x < 0.0 {
        f32::NAN
    } else if x < f32::MIN_POSITIVE {
        ln(x * UP) - 24.0 * LN_2
    } else {
        x
    }
}

/// ln x; −∞ at 0, NaN below.
#[inline]
pub(crate) fn ln(x: f32) -> f32 {
    let bits = x.to_bits();
    if unusual(bits) {
        return ln_of_unusual(x);
    }
    let (m, e) = split(bits);
    sum((m - 1.0) / (m + 1.0), e)
}

/// ln `upper`, where `lower` is 1 − upper with digits of its own: relative accuracy beside 1 too.
#[inline]
pub(crate) fn ln_upper(lower: f32, upper: f32) -> f32 {
    let bits = upper.to_bits();
    if unusual(bits) {
        return ln_of_unusual(upper);
    }
    let (m, e) = split(bits);
    let less_one = if e == 0 { -lower } else { m - 1.0 };
    sum(less_one / (m + 1.0), e)
}

/// ln cos θ; beside the axis, where the cosine has no digits left, from the sine.
///
/// There (cos − 1)/(cos + 1) = −(sin/(1 + cos))², so the quotient of the logarithm of a number is
/// that of this one squared. Times k, the result has the relative error k |ln cos θ| 2⁻²⁰·⁷
/// (2⁻¹⁴·³ where cosᵏθ underflows), and that of `exp` on top. k sin²θ is lost where sin²θ
/// underflows (sin θ < 10⁻¹⁹).
#[inline]
pub(crate) fn ln_cos(cos: f32, sin: f32) -> f32 {
    let bits = cos.to_bits();
    if unusual(bits) {
        return ln_of_unusual(cos);
    }
    let (m, e) = split(bits);
    let near = e == 0;
    let q = if near { sin } else { m - 1.0 } / (m + 1.0);
    sum(if near { -(q * q) } else { q }, e)
}

/// y + 384 lies in [256, 512) for −128 ≤ y < 128: its last bit is 2⁻¹⁵.
const SHIFT: f32 = 384.0;
const LEAST: u32 = (SHIFT - 126.0f32).to_bits();
const BEYOND: u32 = 512.0f32.to_bits();

#[cold]
fn exp2_beyond(y: f32) -> f32 {
    if y.is_nan() {
        y
    } else if y > 0.0 {
        f32::INFINITY
    } else {
        0.0
    }
}

/// 2ʸ; 0 below y = −126, where it would be subnormal.
#[inline]
pub(crate) fn exp2(y: f32) -> f32 {
    let bits = (y + SHIFT).to_bits();
    if bits.wrapping_sub(LEAST) >= BEYOND - LEAST {
        return exp2_beyond(y);
    }
    // The exponent field of the sum is constant; what follows it is (y + 128)·2¹⁵.
    let fraction = (bits & 0x7FFF) << 1;
    let n = (bits >> 15) & 0xFF;
    let significand = EXP2.at(fraction as i32) >> 7;
    f32::from_bits(significand.wrapping_add(n.wrapping_sub(2) << 23))
}

/// eˣ; 0 where it would be subnormal.
#[inline]
pub(crate) fn exp(x: f32) -> f32 {
    exp2(x * LOG2_E)
}

/// 1 − eˣ for x ≤ 0.
#[inline]
pub(crate) fn one_minus_exp(x: f32) -> f32 {
    let y = x * LOG2_E;
    if y > -0.5 {
        // Where the exponent of the sum stays that of 384, its bits differ by y in Q15.
        let q15 = (y + SHIFT).to_bits().wrapping_sub(SHIFT.to_bits());
        -y * leading_31(EXP2_M1.at((q15 << 1) as i32), -1)
    } else {
        1.0 - exp2(y)
    }
}
