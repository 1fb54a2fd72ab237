//! [`SphereShell`] in integers: uniform by radial shell on a sphere.

use super::CoslobeCosSinQ31;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Fixed, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `SphereShell`, uniform by radial shell on a sphere; components in units of 2⁻³¹.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_q31(
    rng: *const CoslobeRng,
    direction: *mut [i32; 3],
) -> CoslobeStatus {
    let law = Fixed(SphereShell);
    // SAFETY: the caller's promise is `draw`'s.
    unsafe {
        draw(rng, direction, |words| {
            law.sample(words).map(I1F31::to_bits)
        })
    }
}

/// (cos θ, sin θ) of `SphereShell` at cdf = `u`, in units of 2⁻³².
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_q31(u: u32) -> CoslobeCosSinQ31 {
    Fixed(SphereShell).warp(U0F32::from_bits(u)).into()
}

/// Density of `SphereShell` at a direction, in units of 2⁻³²: 3 cos²θ / 2π per steradian above the horizon, 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_density_q31(at: CoslobeCosSinQ31) -> u32 {
    Fixed(SphereShell).density(at.into()).to_bits()
}

/// P(Θ ≤ `theta`) of `SphereShell` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
/// and 2³² − 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_cdf_q31(theta: i32) -> u32 {
    Fixed(SphereShell).cdf(I0F32::from_bits(theta)).to_bits()
}

/// θ of `SphereShell` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_quantile_q31(p: u32) -> i32 {
    Fixed(SphereShell).quantile(U0F32::from_bits(p)).to_bits()
}
