//! [`CircleShell`]: uniform by radial shell on a circle: the flat Lambert law.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{CircleShell, Law};

/// Draws a direction [sin θ, cos θ] of `CircleShell`, uniform by radial shell on a circle: the flat Lambert law: 2 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_sample_f32(
    rng: *const CoslobeRng,
    direction: *mut [f32; 2],
) -> CoslobeStatus {
    // SAFETY: the caller's promise is `draw`'s.
    unsafe { draw(rng, direction, |words| CircleShell.sample(words)) }
}

/// (cos θ, sin θ) of `CircleShell` at cdf = `u` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_f32(u: f32) -> CoslobeCosSinF32 {
    CircleShell.warp(u).into()
}

/// Density of `CircleShell` at a direction: cos θ / 2 per radian, θ from −π/2 to π/2; 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_density_f32(at: CoslobeCosSinF32) -> f32 {
    CircleShell.density(at.into())
}

/// P(Θ ≤ `theta`) of `CircleShell`; `theta` in radians from −π/2 to π/2, 0 below and 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_cdf_f32(theta: f32) -> f32 {
    CircleShell.cdf(theta)
}

/// θ in radians of `CircleShell` at cdf = `p` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_quantile_f32(p: f32) -> f32 {
    CircleShell.quantile(p)
}
