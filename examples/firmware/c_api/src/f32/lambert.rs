//! [`Lambert`]: uniform by area on a sphere.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Lambert, Law};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Lambert`, uniform by area on a sphere: 3 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_f32(
    rng: *const CoslobeRng,
    direction: *mut [f32; 3],
) -> CoslobeStatus {
    // SAFETY: the caller's promise is `draw`'s.
    unsafe { draw(rng, direction, |words| Lambert.sample(words)) }
}

/// (cos θ, sin θ) of `Lambert` at cdf = `u` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_f32(u: f32) -> CoslobeCosSinF32 {
    Lambert.warp(u).into()
}

/// Density of `Lambert` at a direction: cos θ / π per steradian, θ from 0 to π/2; 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_density_f32(at: CoslobeCosSinF32) -> f32 {
    Lambert.density(at.into())
}

/// P(Θ ≤ `theta`) of `Lambert`; `theta` in radians from 0 to π/2, 0 below and 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_cdf_f32(theta: f32) -> f32 {
    Lambert.cdf(theta)
}

/// θ in radians of `Lambert` at cdf = `p` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_quantile_f32(p: f32) -> f32 {
    Lambert.quantile(p)
}
