//! Logarithms and exponentials.
//!
//! cosᵏθ = exp(k ln cos θ) multiplies the relative error of ln cos θ by k |ln cos θ| (87 where
//! cosᵏθ underflows), so the logarithm has 2⁻²⁰·⁷, eight bits more than the result needs.

use super::coefficients::{EXP2, EXP2_M1, LN};
use super::fixed::{horner, leading_31};
use super::root::{UP, choose};
use crate::arithmetic::native::f32::power_of_two;
use crate::arithmetic::native::sqrt::unusual;
use crate::scalar::{BY_SELECTS, Scalar};
use core::f32::consts::{FRAC_1_SQRT_2, LN_2, LOG2_E};

/// (m, e) with x = m·2ᵉ, m from √½ to √2, for normal x > 0.
#[inline(always)]
pub(crate) fn split(x: f32) -> (f32, i32) {
    let bits = x.to_bits();
    let e = (bits.wrapping_sub(FRAC_1_SQRT_2.to_bits()) as i32) >> 23;
    let m = f32::from_bits(bits.wrapping_sub((e << 23) as u32));
    (m, e)
}

/// e as a number; on x86-64 without a conversion, which waits for what its register held.
#[inline(always)]
pub(crate) fn float(e: i32) -> f32 {
    const CARRIER: f32 = 12_582_912.0;
    if BY_SELECTS {
        f32::from_bits(CARRIER.to_bits().wrapping_add(e as u32)) - CARRIER
    } else {
        e as f32
    }
}

/// By selects, subnormal x is made normal.
#[inline(always)]
fn normal<const SELECTS: bool>(x: f32) -> f32 {
    if SELECTS {
        x * f32::select(x < f32::MIN_POSITIVE, UP, 1.0)
    } else {
        x
    }
}

/// ln [`UP`].
const LN_UP: f32 = 24.0 * LN_2;

/// e ln 2 + 2 atanh z.
#[inline(always)]
fn sum(z: f32, e: i32) -> f32 {
    z * horner(z * z, &LN) + float(e) * LN_2
}

/// ln x; −∞ at 0, NaN below.
#[inline]
pub(crate) fn ln(x: f32) -> f32 {
    ln_by::<BY_SELECTS>(x)
}

#[cold]
fn ln_of_unusual(x: f32) -> f32 {
    if x == 0.0 {
        f32::NEG_INFINITY
    } else if x < 0.0 {
        f32::NAN
    } else if x < f32::MIN_POSITIVE {
        ln(x * UP) - LN_UP
    } else {
        x
    }
}

#[inline(always)]
pub(super) fn ln_by<const SELECTS: bool>(x: f32) -> f32 {
    if !SELECTS && unusual(x.to_bits()) {
        return ln_of_unusual(x);
    }
    let (m, e) = split(normal::<SELECTS>(x));
    at_ends::<SELECTS>(x, sum((m - 1.0) / (m + 1.0), e))
}

/// `ln`, less that of [`UP`] where x is subnormal; or that of 0, a negative number, ∞ or NaN.
#[inline(always)]
fn at_ends<const SELECTS: bool>(x: f32, ln: f32) -> f32 {
    if !SELECTS {
        return ln;
    }
    let below = f32::select(x < 0.0, f32::NAN, f32::NEG_INFINITY);
    let ln = ln - f32::select(x < f32::MIN_POSITIVE, LN_UP, 0.0);
    let ln = f32::select(x > 0.0, ln, below);
    f32::select(x < f32::INFINITY, ln, x)
}

/// ln cos θ; beside the axis, where the cosine has no digits left, from the sine.
///
/// There (cos − 1)/(cos + 1) = −(sin/(1 + cos))², so the quotient of the logarithm of a number is
/// that of this one squared. Times k, the result has the relative error k |ln cos θ| 2⁻²⁰·⁷
/// (2⁻¹⁴·³ where cosᵏθ underflows), and that of `exp` on top. k sin²θ is lost where sin²θ
/// underflows (sin θ < 10⁻¹⁹).
#[inline]
pub(crate) fn ln_cos(cos: f32, sin: f32) -> f32 {
    ln_cos_by::<BY_SELECTS>(cos, sin)
}

#[inline(always)]
pub(super) fn ln_cos_by<const SELECTS: bool>(cos: f32, sin: f32) -> f32 {
    if !SELECTS && unusual(cos.to_bits()) {
        return ln_of_unusual(cos);
    }
    let (m, e) = split(normal::<SELECTS>(cos));
    let near = e == 0;
    let q = choose::<SELECTS>(near, || sin, || m - 1.0) / (m + 1.0);
    at_ends::<SELECTS>(cos, sum(choose::<SELECTS>(near, || -(q * q), || q), e))
}

/// y + 384 lies in [256, 512) for −128 ≤ y < 128: its last bit is 2⁻¹⁵.
pub(crate) const SHIFT: f32 = 384.0;
const LEAST: u32 = (SHIFT - 126.0f32).to_bits();
const BEYOND: u32 = 512.0f32.to_bits();

/// An exponent −126 ≤ y < 128 in fixed point.
#[derive(Clone, Copy)]
pub(crate) struct Exponent(u32);

impl Exponent {
    #[inline(always)]
    pub(crate) fn of(y: f32) -> Self {
        Exponent((y + SHIFT).to_bits())
    }

    /// Of y + 64, for −192 ≤ y < 64, rounded as y would be.
    #[inline(always)]
    pub(crate) fn lifted(y: f32) -> Self {
        Exponent((y + (SHIFT + 64.0)).to_bits())
    }

    /// Where y lies beyond, there is another number here.
    #[inline(always)]
    fn is_inside(self) -> bool {
        self.0.wrapping_sub(LEAST) < BEYOND - LEAST
    }

    /// 2ʸ; for y ≤ 0 not above 1.
    #[inline(always)]
    pub(crate) fn power(self) -> f32 {
        // What follows the sum's exponent is (y + 128)·2¹⁵: in place, 2ʸ but for its significand's
        // curve, 2ˣ − x of the fraction x.
        let half = (self.0 & 0x7FFF) as i32;
        let curve = (EXP2.at(half) as i32 >> 7) as u32;
        f32::from_bits((self.0 << 8).wrapping_add(curve).wrapping_add(255 << 23))
    }

    /// (2ʸ − 1)/y for −⅜ < y ≤ 0.
    #[inline(always)]
    pub(crate) fn slope(self) -> f32 {
        let half = (self.0.wrapping_neg() & 0x7FFF) as i32;
        leading_31(EXP2_M1.at(half), -1)
    }
}

/// Above it, 2ʸ − 1 is y times [`Exponent::slope`].
pub(crate) const NEAR_ZERO: f32 = -0.375;

#[cold]
fn exp2_beyond(y: f32) -> f32 {
    if y.is_nan() {
        y
    } else if y.is_sign_negative() {
        0.0
    } else {
        f32::INFINITY
    }
}

/// 2ʸ; 0 below y = −126, where it would be subnormal.
#[inline]
fn exp2_by<const SELECTS: bool>(y: f32) -> f32 {
    let exponent = Exponent::of(y);
    if !SELECTS {
        return if exponent.is_inside() {
            exponent.power()
        } else {
            exp2_beyond(y)
        };
    }
    let end = f32::select(y > 0.0, f32::INFINITY, 0.0);
    let end = f32::select(y.is_nan(), y, end);
    f32::select(exponent.is_inside(), exponent.power(), end)
}

/// c·eᵃ, also where eᵃ alone would leave the range of the format.
#[inline(always)]
pub(crate) fn exp_times(a: f32, c: f32) -> f32 {
    exp_times_by::<BY_SELECTS>(a, c)
}

#[cold]
fn far_exp_times(a: f32, c: f32) -> f32 {
    lifted::<false>(
        a,
        c,
        if a.is_sign_negative() {
            LIFT_DOWN
        } else {
            LIFT_UP
        },
    )
}

/// A part, and the logarithm of two of its reciprocal.
type Lift = (f32, f32);
const LIFT_DOWN: Lift = (power_of_two(-76), 152.0);
const LIFT_UP: Lift = (power_of_two(76), -152.0);

/// c·eᵃ with a power of two taken from the exponential and put to it in two parts, of which the
/// first keeps the product in range.
#[inline(always)]
fn lifted<const SELECTS: bool>(a: f32, c: f32, (part, shift): Lift) -> f32 {
    c * part * exp2_by::<SELECTS>(a * LOG2_E + shift) * part
}

#[inline(always)]
pub(super) fn exp_times_by<const SELECTS: bool>(a: f32, c: f32) -> f32 {
    let near = a.abs() < 86.0;
    if SELECTS {
        let far = |down, up| f32::select(a < 0.0, down, up);
        let part = f32::select(near, 1.0, far(LIFT_DOWN.0, LIFT_UP.0));
        let shift = f32::select(near, 0.0, far(LIFT_DOWN.1, LIFT_UP.1));
        lifted::<true>(a, c, (part, shift))
    } else if near {
        c * exp2_by::<false>(a * LOG2_E)
    } else {
        far_exp_times(a, c)
    }
}

/// 1 − eˣ for x ≤ 0.
#[inline]
pub(crate) fn one_minus_exp(x: f32) -> f32 {
    one_minus_exp_by::<BY_SELECTS>(x)
}

#[inline(always)]
pub(super) fn one_minus_exp_by<const SELECTS: bool>(x: f32) -> f32 {
    let y = x * LOG2_E;
    choose::<SELECTS>(
        y > NEAR_ZERO,
        || -y * Exponent::of(y).slope(),
        || 1.0 - exp2_by::<SELECTS>(y),
    )
}
