//! Lambert's cos θ / π over a law's density (in the plane, half its cosine), in Q16.

use super::format::Format;
use super::kernel::normal::normal;
use crate::CosSin;
use ::fixed::types::U16F16;

/// product·2^(shift − 15) of a product in Q32, to the nearest; what is too large saturates.
#[inline(always)]
pub(crate) fn q16(product: u32, shift: i32) -> U16F16 {
    let up = shift.wrapping_sub(15);
    U16F16::from_bits(if up < 0 {
        let twice = product >> up.wrapping_add(1).unsigned_abs().min(31);
        (twice >> 1).wrapping_add(twice & 1)
    } else if up < 32 && (product >> 1).wrapping_shr(31u32.wrapping_sub(up as u32)) == 0 {
        product << up
    } else {
        u32::MAX
    })
}

/// `numerator` / cos θ, the numerator below 1 and in Q32.
#[inline(always)]
pub(crate) fn over_cosine<F: Format>(at: CosSin<i32>, numerator: u32) -> U16F16 {
    let (recip, shift) = half_secant::<F>(at);
    q16(F::times(recip, numerator), shift)
}

/// r and s with 1/(2 cos θ) = r·2ˢ, r in Q32, for cos θ > 0.
#[inline(always)]
pub(crate) fn half_secant<F: Format>(at: CosSin<i32>) -> (u32, i32) {
    let (m, shift) = normal((at.cos as u32) << 1);
    (F::half_recip(m), shift as i32)
}

/// 0 below the horizon and, in space, for sin θ < 0; `at_horizon` at cos θ = 0, `above` elsewhere.
#[inline(always)]
pub(crate) fn within(
    at: CosSin<i32>,
    is_planar: bool,
    at_horizon: U16F16,
    above: impl FnOnce() -> U16F16,
) -> U16F16 {
    if at.cos < 0 || (at.sin < 0 && !is_planar) {
        U16F16::ZERO
    } else if at.cos == 0 {
        at_horizon
    } else {
        above()
    }
}
