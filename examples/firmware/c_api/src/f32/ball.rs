//! [`Ball`]: uniform by volume in a ball.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Ball, Law};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Ball`, uniform by volume in a ball: 3 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_f32(
    rng: *const CoslobeRng,
    direction: *mut [f32; 3],
) -> CoslobeStatus {
    // SAFETY: the caller's promise is `draw`'s.
    unsafe { draw(rng, direction, |words| Ball.sample(words)) }
}

/// (cos θ, sin θ) of `Ball` at cdf = `u` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_f32(u: f32) -> CoslobeCosSinF32 {
    Ball.warp(u).into()
}

/// Density of `Ball` at a direction: 2 cos³θ / π per steradian, θ from 0 to π/2; 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_density_f32(at: CoslobeCosSinF32) -> f32 {
    Ball.density(at.into())
}

/// P(Θ ≤ `theta`) of `Ball`; `theta` in radians from 0 to π/2, 0 below and 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_cdf_f32(theta: f32) -> f32 {
    Ball.cdf(theta)
}

/// θ in radians of `Ball` at cdf = `p` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_quantile_f32(p: f32) -> f32 {
    Ball.quantile(p)
}
