//! Roots. Of a cube root the exponent is divided, the significand goes through a polynomial in
//! integers.

use super::coefficients::CBRT;
use crate::arithmetic::native::float::Float;
use crate::arithmetic::native::sqrt::unusual;
use crate::scalar::{BY_SELECTS, Scalar};

/// 2²⁴: makes a subnormal number normal.
pub(crate) const UP: f32 = 16_777_216.0;

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

/// ∛x for x > 0, at most moderately large (2¹⁰⁰); ±0 and NaN as they are. Of no number up to 1 it
/// is above 1.
#[inline]
pub(crate) fn cbrt(x: f32) -> f32 {
    cbrt_by::<BY_SELECTS>(x)
}

#[inline(always)]
pub(super) fn cbrt_by<const SELECTS: bool>(x: f32) -> f32 {
    if SELECTS {
        // Scaled up always: no choice for subnormal numbers.
        f32::select(x > 0.0, of_normal::<true>((x * UP).to_bits(), BIAS - 24), x)
    } else {
        of_any(x.to_bits())
    }
}

/// A subnormal number is made normal by integers: for a product, which may be a routine, each
/// caller would save registers.
#[inline(always)]
fn of_any(bits: u32) -> f32 {
    let (mut scaled, mut shift) = (bits, 0);
    if unusual(bits) {
        if bits.wrapping_sub(1) >= f32::MIN_POSITIVE.to_bits() {
            return f32::from_bits(bits);
        }
        shift = bits.leading_zeros().wrapping_sub(8);
        scaled = bits.wrapping_shl(shift);
    }
    of_normal::<false>(scaled, BIAS.wrapping_sub(shift))
}

/// Twice the exponent's, less 3: the leading one of the root's significand counts in its exponent.
const BIAS: u32 = 251;

/// ∛2, so that the root of 1 is 1, and that of no number below it more.
const PART_Q14: u32 = 20642;
const PART_Q23: u32 = 10_568_920;

/// Of the pattern of a normal number scaled by 2^([`BIAS`] − `bias`); some number of others.
///
/// 2(1 − x) is the significand. All factors have 16 bits, as vectors need it, and by selects the
/// compiler sees that they have.
#[inline(always)]
fn of_normal<const SELECTS: bool>(bits: u32, bias: u32) -> f32 {
    // n / 3 in Q16, for n ≤ 511
    let thirds = (bits >> 23).wrapping_add(bias).wrapping_mul(21846);
    let rest = (thirds >> 14) & 3;
    // 2^(1/3, 2/3, 1) in Q16, less the first
    let more = if SELECTS {
        rest.wrapping_mul(21462)
            .wrapping_add((rest >> 1).wrapping_mul(5578))
    } else {
        rest.wrapping_mul(rest.wrapping_mul(2789).wrapping_add(18673))
    };
    let part = (more >> 2).wrapping_add(PART_Q14);
    let part = if SELECTS { part & 0x7FFF } else { part };
    let x = (bits >> 8) & 0x7FFF ^ 0x7FFF;
    let less = CBRT.at(x as i32) as i32 >> 16;
    let product = (part as i32).wrapping_mul(less) >> 7;
    let root = (thirds & 0xFFFF_0000).wrapping_add(more) << 7;
    f32::from_bits(root.wrapping_add(PART_Q23).wrapping_add(product as u32))
}

/// Of what was scaled by [`UP`].
#[inline(always)]
pub(crate) fn scaled_root(x: f32) -> f32 {
    Scalar::sqrt(x) * f32::ROOT_DOWN
}

/// Half of what is no less is normal. Of a tail that is less, the other is 1.
const SAFE: f32 = 2.0 * f32::MIN_POSITIVE;

/// (cos θ, sin θ) at a tail below [`SAFE`] with sin²θ = lower·ratio: scaled up, so that a subnormal
/// product loses no digits. The last call of who makes it, so that no register is saved for it.
#[cold]
fn beside_axis(lower: f32, ratio: f32) -> (f32, f32) {
    (1.0, scaled_root(lower * UP * ratio))
}

/// (cos θ, sin θ) with cos³θ = upper.
#[inline(always)]
pub(crate) fn cube_warp(lower: f32, upper: f32) -> (f32, f32) {
    cube_warp_by::<BY_SELECTS>(lower, upper)
}

#[inline(always)]
pub(super) fn cube_warp_by<const SELECTS: bool>(lower: f32, upper: f32) -> (f32, f32) {
    let cos = cbrt_by::<SELECTS>(upper);
    let next = 1.0 + cos;
    let ratio = next / (next + cos * cos);
    if SELECTS {
        (cos, scaled_root(lower * UP * ratio))
    } else if lower.to_bits() < SAFE.to_bits() {
        beside_axis(lower, ratio)
    } else {
        (cos, Scalar::sqrt(lower * ratio))
    }
}

/// Below it, sin²θ of [`fourth_power_warp`] is half the lower tail.
const AXIS: f32 = 1.0 / 1024.0;
/// With the error 2⁻¹⁴ of the sine either way.
const HALF: f32 = 0.5 + AXIS / 16.0;

/// (cos θ, sin θ) with cos⁴θ = upper.
///
/// sin²θ = 1 − cos²θ, but beside the axis, where that has no digits left. By selects all is scaled
/// up, so that of a subnormal tail none are lost.
#[inline(always)]
pub(crate) fn fourth_power_warp(lower: f32, upper: f32) -> (f32, f32) {
    fourth_power_warp_by::<BY_SELECTS>(lower, upper)
}

#[inline(always)]
pub(super) fn fourth_power_warp_by<const SELECTS: bool>(lower: f32, upper: f32) -> (f32, f32) {
    let square = Scalar::sqrt(upper);
    if SELECTS {
        let (half, rest) = (lower * (UP * HALF), UP - square * UP);
        let sin = scaled_root(f32::select(lower < AXIS, half, rest));
        return (Scalar::sqrt(square), sin);
    }
    let part = if lower.to_bits() >= AXIS.to_bits() {
        1.0 - square
    } else if lower.to_bits() >= SAFE.to_bits() {
        lower * HALF
    } else {
        return beside_axis(lower, HALF);
    };
    (Scalar::sqrt(square), Scalar::sqrt(part))
}
