//! [`CosPower`]: the Phong lobe. An exponent that is NaN, negative or infinite gives NaN.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{CosPower, CosSin, Law};

const NAN_PAIR: CosSin<f32> = CosSin {
    cos: f32::NAN,
    sin: f32::NAN,
};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of the law ∝ cosᵏθ, k = `exponent` ≥ 0 and finite:
/// 3 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_f32(
    exponent: f32,
    rng: *const CoslobeRng,
    direction: *mut [f32; 3],
) -> CoslobeStatus {
    match CosPower::new(exponent) {
        // SAFETY: the caller's promise is `draw`'s.
        Ok(law) => unsafe { draw(rng, direction, |words| law.sample(words)) },
        Err(_) => CoslobeStatus::Exponent,
    }
}

/// (cos θ, sin θ) of the law ∝ cosᵏθ at cdf = `u` from 0 to 1; NaN elsewhere, and for a bad `exponent`.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_warp_f32(exponent: f32, u: f32) -> CoslobeCosSinF32 {
    let at = CosPower::new(exponent).map_or(NAN_PAIR, |law| law.warp(u));
    at.into()
}

/// Density of the law ∝ cosᵏθ at a direction: (k+1) cosᵏθ / 2π per steradian, θ from 0 to π/2; 0 elsewhere,
/// NaN for a bad `exponent`.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_density_f32(exponent: f32, at: CoslobeCosSinF32) -> f32 {
    CosPower::new(exponent).map_or(f32::NAN, |law| law.density(at.into()))
}

/// P(Θ ≤ `theta`) of the law ∝ cosᵏθ; `theta` in radians from 0 to π/2, 0 below and 1 above. NaN for a bad
/// `exponent`.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_cdf_f32(exponent: f32, theta: f32) -> f32 {
    CosPower::new(exponent).map_or(f32::NAN, |law| law.cdf(theta))
}

/// θ in radians of the law ∝ cosᵏθ at cdf = `p` from 0 to 1; NaN elsewhere, and for a bad `exponent`.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_cos_power_quantile_f32(exponent: f32, p: f32) -> f32 {
    CosPower::new(exponent).map_or(f32::NAN, |law| law.quantile(p))
}
