//! [`Disk`] in integers: uniform by area in a disk.

use super::CoslobeCosSinQ31;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Disk, Fixed};
use fixed::types::{I0F32, I1F31, U0F32};

/// Draws a direction [sin θ, cos θ] of `Disk`, uniform by area in a disk; components in units of 2⁻³¹.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_sample_q31(
    rng: *const CoslobeRng,
    direction: *mut [i32; 2],
) -> CoslobeStatus {
    let law = Fixed(Disk);
    // SAFETY: the caller's promise is `draw`'s.
    unsafe {
        draw(rng, direction, |words| {
            law.sample(words).map(I1F31::to_bits)
        })
    }
}

/// (cos θ, sin θ) of `Disk` at cdf = `u`, in units of 2⁻³².
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_q31(u: u32) -> CoslobeCosSinQ31 {
    Fixed(Disk).warp(U0F32::from_bits(u)).into()
}

/// Density of `Disk` at a direction, in units of 2⁻³²: 2 cos²θ / π per radian above the horizon, 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_density_q31(at: CoslobeCosSinQ31) -> u32 {
    Fixed(Disk).density(at.into()).to_bits()
}

/// P(Θ ≤ `theta`) of `Disk` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from −¼ to ¼ turn: 0 below
/// and 2³² − 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_cdf_q31(theta: i32) -> u32 {
    Fixed(Disk).cdf(I0F32::from_bits(theta)).to_bits()
}

/// θ of `Disk` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_quantile_q31(p: u32) -> i32 {
    Fixed(Disk).quantile(U0F32::from_bits(p)).to_bits()
}
