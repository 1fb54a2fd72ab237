//! [`Disk`]: uniform by area in a disk.

use super::CoslobeCosSinF32;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Disk, Law};

/// Draws a direction [sin θ, cos θ] of `Disk`, uniform by area in a disk: 2 words of `rng`.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_sample_f32(
    rng: *const CoslobeRng,
    direction: *mut [f32; 2],
) -> CoslobeStatus {
    // SAFETY: the caller's promise is `draw`'s.
    unsafe { draw(rng, direction, |words| Disk.sample(words)) }
}

/// (cos θ, sin θ) of `Disk` at cdf = `u` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_f32(u: f32) -> CoslobeCosSinF32 {
    Disk.warp(u).into()
}

/// Density of `Disk` at a direction: 2 cos²θ / π per radian, θ from −π/2 to π/2; 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_density_f32(at: CoslobeCosSinF32) -> f32 {
    Disk.density(at.into())
}

/// P(Θ ≤ `theta`) of `Disk`; `theta` in radians from −π/2 to π/2, 0 below and 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_cdf_f32(theta: f32) -> f32 {
    Disk.cdf(theta)
}

/// θ in radians of `Disk` at cdf = `p` from 0 to 1; NaN elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_quantile_f32(p: f32) -> f32 {
    Disk.quantile(p)
}
