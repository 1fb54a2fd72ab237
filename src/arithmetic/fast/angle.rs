//! Angles to (cos, sin) and back.

use super::coefficients::{ATAN, AZIMUTH_COS, AZIMUTH_SHIFT, AZIMUTH_SIN, COS, HALF_TURN, SIN};
use super::fixed::{at_most_one, horner};
use crate::arithmetic::native::sqrt::unusual;
use crate::scalar::BY_SELECTS;
use core::f32::consts::{FRAC_PI_2, PI};

/// π/2 less the `f32` nearest to it.
const HALF_PI_LO: f32 = -4.371139e-8;
const HALF_PI_DOWN: f32 = f32::from_bits(FRAC_PI_2.to_bits() - 1);
const SIGN: u32 = 1 << 31;

/// π/2 − a, which keeps its digits beside π/2.
#[inline(always)]
pub(crate) fn from_end(a: f32) -> f32 {
    (FRAC_PI_2 - a) + HALF_PI_LO
}

/// (cos θ, |sin θ|) for |θ| ≤ π/2.
///
/// Each is an odd polynomial of the distance from its own zero: no folding, and both relative.
#[inline]
pub(crate) fn sin_cos(theta: f32) -> (f32, f32) {
    let a = theta.abs();
    let eta = from_end(a);
    (eta * horner(eta * eta, &COS), a * horner(a * a, &SIN))
}

/// (cos 2πu, sin 2πu) for 0 ≤ u ≤ 1, neither beyond 1.
///
/// With m = min(u, 1 − u) and p = m (½ − u), cos is (¼ − m)(c₀ + c₁T) and sin p (q₀ + 16 s + q₁T),
/// s = |p|, T = s (s + k). All three zeros are factors, which lose no digits and have their signs,
/// so that no quadrant is told, and both share the polynomials' first product. Where u is below
/// 2⁻¹²⁵ the sine has fewer digits.
#[inline(always)]
pub(crate) fn turn(u: f32) -> (f32, f32) {
    turn_by::<BY_SELECTS>(u)
}

#[inline(always)]
pub(super) fn turn_by<const SELECTS: bool>(u: f32) -> (f32, f32) {
    let m = if SELECTS {
        let rest = 1.0 - u;
        if u < rest { u } else { rest }
    } else if u.to_bits() as i32 <= 0.5f32.to_bits() as i32 {
        u
    } else {
        1.0 - u
    };
    let p = m * (0.5 - u);
    let s = p.abs();
    let t = s * (s + AZIMUTH_SHIFT);
    // By the exponent; a sum with q₀ is the same where s is 0 or subnormal.
    let sixteen_s = f32::from_bits(s.to_bits().wrapping_add(4 << 23));
    let [c0, c1] = AZIMUTH_COS;
    let [q0, q1] = AZIMUTH_SIN;
    ((0.25 - m) * (c0 + c1 * t), p * ((q0 + sixteen_s) + q1 * t))
}

/// (cos, sin) of the angle πp from an end, 0 ≤ p ≤ 1/2: cos is that of the angle from the axis.
#[inline]
pub(crate) fn half_turn(p: f32) -> (f32, f32) {
    let d = 0.5 - p;
    let component = |x: f32| at_most_one(x * horner(x * x, &HALF_TURN));
    (component(p), component(d))
}

#[cold]
fn ratio_of_unusual(smaller: f32, larger: f32) -> f32 {
    if larger.is_nan() {
        larger
    } else if larger > smaller || larger == 0.0 {
        0.0
    } else {
        1.0
    }
}

/// atan2(|y|, ±|x|), in [0, π].
#[inline(always)]
fn upper_half(y: u32, x: u32, behind: bool) -> f32 {
    let steep = y > x;
    let (smaller, larger) = (f32::from_bits(y.min(x)), f32::from_bits(y.max(x)));
    let t = if unusual(larger.to_bits()) {
        ratio_of_unusual(smaller, larger)
    } else {
        smaller / larger
    };
    let r = t * horner(t * t, &ATAN);
    // 0 + r, π/2 ∓ r or π − r. The rounded-down π/2 keeps the first quadrant inside the support.
    let flat = if behind { PI.to_bits() } else { 0 };
    let right = if behind { FRAC_PI_2 } else { HALF_PI_DOWN }.to_bits();
    let mask = u32::from(steep).wrapping_neg();
    let base = (right & mask) | (flat & !mask);
    f32::from_bits(base) + f32::from_bits(r.to_bits() ^ (u32::from(steep != behind) << 31))
}

/// atan2(|y|, |x|), in [0, π/2].
#[inline]
pub(crate) fn atan2_first(y: f32, x: f32) -> f32 {
    upper_half(y.to_bits() & !SIGN, x.to_bits() & !SIGN, false)
}

/// atan2(y, x) in all quadrants.
#[inline]
pub(crate) fn atan2(y: f32, x: f32) -> f32 {
    let (y, x) = (y.to_bits(), x.to_bits());
    let a = upper_half(y & !SIGN, x & !SIGN, x & SIGN != 0);
    f32::from_bits(a.to_bits() ^ (y & SIGN))
}
