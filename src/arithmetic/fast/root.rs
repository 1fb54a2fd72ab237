//! The cube root: the exponent divided, the significand by an integer polynomial of degree 4.

use super::coefficients::CBRT;
use crate::arithmetic::native::float::Float;
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
        f32::select(x > 0.0, of_scaled::<true>(x), x)
    } else if unusual(x.to_bits()) {
        of_unusual(x)
    } else {
        of_normal::<false>(x.to_bits(), BIAS)
    }
}

#[cold]
fn of_unusual(x: f32) -> f32 {
    if x > 0.0 && x < f32::MIN_POSITIVE {
        of_scaled::<false>(x)
    } else {
        x
    }
}

#[inline(always)]
fn of_scaled<const SELECTS: bool>(x: f32) -> f32 {
    of_normal::<SELECTS>((x * UP).to_bits(), BIAS - 24)
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

/// (cos θ, sin θ) with cos⁴θ = upper.
///
/// sin²θ = 1 − cos²θ; beside the axis, where that has no digits left, half the lower tail, with
/// the error 2⁻¹⁴ either way. Scaled up, so that of a subnormal tail none are lost.
#[inline(always)]
pub(crate) fn fourth_power_warp(lower: f32, upper: f32) -> (f32, f32) {
    const AXIS: f32 = 1.0 / 1024.0;
    const HALF: f32 = UP * (0.5 + AXIS / 16.0);
    let square = Scalar::sqrt(upper);
    let near = if BY_SELECTS {
        lower < AXIS
    } else {
        lower.to_bits() < AXIS.to_bits()
    };
    let sin_squared = choose::<BY_SELECTS>(near, || lower * HALF, || UP - square * UP);
    (
        Scalar::sqrt(square),
        Scalar::sqrt(sin_squared) * f32::ROOT_DOWN,
    )
}
