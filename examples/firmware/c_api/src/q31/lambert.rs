//! [`Lambert`] in integers: uniform by area on a sphere.

use super::CoslobeCosSinQ31;
use crate::boundary::{CoslobeRng, CoslobeStatus, draw};
use coslobe::{Fixed, Lambert};
use fixed::types::{I0F32, I1F31, U0F32};

/// Draws a direction [sin θ cos φ, cos θ, sin θ sin φ] of `Lambert`, uniform by area on a sphere; components in units of 2⁻³¹.
///
/// # Safety
/// Each pointer is null, which is answered by its status, or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_q31(
    rng: *const CoslobeRng,
    direction: *mut [i32; 3],
) -> CoslobeStatus {
    let law = Fixed(Lambert);
    // SAFETY: the caller's promise is `draw`'s.
    unsafe {
        draw(rng, direction, |words| {
            law.sample(words).map(I1F31::to_bits)
        })
    }
}

/// (cos θ, sin θ) of `Lambert` at cdf = `u`, in units of 2⁻³².
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_q31(u: u32) -> CoslobeCosSinQ31 {
    Fixed(Lambert).warp(U0F32::from_bits(u)).into()
}

/// Density of `Lambert` at a direction, in units of 2⁻³²: cos θ / π per steradian above the horizon, 0 elsewhere.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_density_q31(at: CoslobeCosSinQ31) -> u32 {
    Fixed(Lambert).density(at.into()).to_bits()
}

/// P(Θ ≤ `theta`) of `Lambert` in units of 2⁻³², saturated; `theta` in units of 2⁻³² turns, from 0 to ¼ turn: 0 below
/// and 2³² − 1 above.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_cdf_q31(theta: i32) -> u32 {
    Fixed(Lambert).cdf(I0F32::from_bits(theta)).to_bits()
}

/// θ of `Lambert` at cdf = `p`·2⁻³², in units of 2⁻³² turns.
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_quantile_q31(p: u32) -> i32 {
    Fixed(Lambert).quantile(U0F32::from_bits(p)).to_bits()
}
