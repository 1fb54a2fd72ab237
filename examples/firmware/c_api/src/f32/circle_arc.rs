//! [`CircleArc`]: uniform by arc length on a circle.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{CircleArc, Law};

/// Draws a direction [sin θ, cos θ] of `CircleArc`, uniform by arc length on a circle: 2 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_sample_f32(
    rng: *const CoslobeRng,
    direction: *mut [f32; 2],
) -> CoslobeStatus {
    // SAFETY: the caller's promise is `draw`'s.
    unsafe { draw(rng, direction, |words| CircleArc.sample(words)) }
}

/// (cos θ, sin θ) of `CircleArc` at cdf = `u` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_f32(u: f32) -> CoslobeCosSinF32 {
    CircleArc.warp(u).into()
}

/// Density of `CircleArc` at a direction: 1/π per radian, θ from −π/2 to π/2; 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_density_f32(at: CoslobeCosSinF32) -> f32 {
    CircleArc.density(at.into())
}

/// P(Θ ≤ `theta`) of `CircleArc`; `theta` in radians from −π/2 to π/2, 0 below and 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_cdf_f32(theta: f32) -> f32 {
    CircleArc.cdf(theta)
}

/// θ in radians of `CircleArc` at cdf = `p` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_quantile_f32(p: f32) -> f32 {
    CircleArc.quantile(p)
}
