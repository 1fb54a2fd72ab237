//! [`CosPower`] in integers: ∝ cosᵏθ.

use super::CoslobeCosSinQ31;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::Fixed;
use coslobe::fixed::CosPower;
use fixed::types::{I0F32, I1F31, U0F32, U16F16};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶; components in units of 2⁻³¹.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_q31(
    exponent: u32,
    rng: *const CoslobeRng,
    direction: *mut [i32; 3],
) -> CoslobeStatus {
    let law = Fixed(CosPower::new(U16F16::from_bits(exponent)));
    // SAFETY: the caller's promise is `draw`'s.
    unsafe {
        draw(rng, direction, |words| {
            law.sample(words).map(I1F31::to_bits)
        })
    }
}

/// (cos θ, sin θ) of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ at cdf = `u`, in units of 2⁻³².
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_warp_q31(exponent: u32, u: u32) -> CoslobeCosSinQ31 {
    Fixed(CosPower::new(U16F16::from_bits(exponent)))
        .warp(U0F32::from_bits(u))
        .into()
}

/// Density of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ at a direction, in units of 2⁻¹⁶: (k+1) cosᵏθ / 2π per steradian above the horizon, 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_density_q31(exponent: u32, at: CoslobeCosSinQ31) -> u32 {
    Fixed(CosPower::new(U16F16::from_bits(exponent)))
        .density(at.into())
        .to_bits()
}

/// P(Θ ≤ `theta`) of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
/// and 2³² − 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_cdf_q31(exponent: u32, theta: i32) -> u32 {
    Fixed(CosPower::new(U16F16::from_bits(exponent)))
        .cdf(I0F32::from_bits(theta))
        .to_bits()
}

/// θ of the law ∝ cosᵏθ, k = `exponent`·2⁻¹⁶ at cdf = `p`·2⁻³², in units of 2⁻³² turns.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_quantile_q31(exponent: u32, p: u32) -> i32 {
    Fixed(CosPower::new(U16F16::from_bits(exponent)))
        .quantile(U0F32::from_bits(p))
        .to_bits()
}
