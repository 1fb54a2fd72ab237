//! [`SphereShell`]: uniform by radial shell on a sphere.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Law, SphereShell};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `SphereShell`, uniform by radial shell on a sphere: 3 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_f32(
    rng: *const CoslobeRng,
    direction: *mut [f32; 3],
) -> CoslobeStatus {
    // SAFETY: the caller's promise is `draw`'s.
    unsafe { draw(rng, direction, |words| SphereShell.sample(words)) }
}

/// (cos θ, sin θ) of `SphereShell` at cdf = `u` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_f32(u: f32) -> CoslobeCosSinF32 {
    SphereShell.warp(u).into()
}

/// Density of `SphereShell` at a direction: 3 cos²θ / 2π per steradian, θ from 0 to π/2; 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_density_f32(at: CoslobeCosSinF32) -> f32 {
    SphereShell.density(at.into())
}

/// P(Θ ≤ `theta`) of `SphereShell`; `theta` in radians from 0 to π/2, 0 below and 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_cdf_f32(theta: f32) -> f32 {
    SphereShell.cdf(theta)
}

/// θ in radians of `SphereShell` at cdf = `p` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_quantile_f32(p: f32) -> f32 {
    SphereShell.quantile(p)
}
