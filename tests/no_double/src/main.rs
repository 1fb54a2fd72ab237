//! Every `f32` operation in one image. It links only if no panic is reachable, since the panic handler
//! calls a symbol that exists nowhere, and `check` refuses it if a soft-double routine is linked.
//! `--cfg planted` adds one sum in `f64`, which the check must catch.
#![no_std]
#![no_main]

use core::convert::Infallible;
use coslobe::rand_core::TryRng;
use coslobe::*;

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe { a_panic_is_reachable() }
}

struct Words(u32);

impl TryRng for Words {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(1);
        Ok(self.0)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(u64::from(self.try_next_u32()?) << 32 | u64::from(self.try_next_u32()?))
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for byte in bytes {
            *byte = self.try_next_u32()? as u8;
        }
        Ok(())
    }
}

fn every_operation(law: &impl Law<f32>, x: f32) -> f32 {
    let (a, b, m) = (law.warp(x), law.warp_sf(x), law.moments());
    law.pdf(x)
        + law.ln_pdf(x)
        + law.cdf(x)
        + law.sf(x)
        + law.quantile(x)
        + law.isf(x)
        + a.cos
        + b.sin
        + law.unwarp(a)
        + law.unwarp_sf(b)
        + law.density(a)
        + law.lambert_weight(b)
        + m.entropy
        + m.var_theta
}

fn point(law: &(impl Tangent<f32> + SpatialPoint<f32>), rho: Radius<f32>, rng: &mut Words) -> f32 {
    let at = law.warp(0.5);
    law.point_density(rho, at, 0.1)
        + law.ln_point_density(rho, at, 0.1)
        + law.sample_point(rho, rng)[0]
}

/// The image's entry: what it returns depends on every operation.
#[unsafe(no_mangle)]
pub extern "C" fn _start(x: f32, seed: u32) -> f32 {
    let mut rng = Words(seed);
    let mut sum = every_operation(&Disk, x)
        + every_operation(&CircleShell, x)
        + every_operation(&CircleArc, x)
        + every_operation(&Ball, x)
        + every_operation(&SphereShell, x)
        + every_operation(&Lambert, x);
    if let Ok(law) = CosPower::new(x) {
        let d = law.sample(&mut rng);
        sum += every_operation(&law, x) + d[0] + law.pdf_solid_angle(x);
    }
    if let Ok(rho) = Radius::new(x) {
        sum += point(&Ball, rho, &mut rng) + point(&SphereShell, rho, &mut rng);
        sum += point(&Lambert, rho, &mut rng) + Disk.sample_point(rho, &mut rng)[0];
    }
    if let Ok(frame) = Frame::new([x, sum, 1.0]) {
        sum += frame.to_local([1.0, x, sum])[0] + frame.to_world([1.0, x, sum])[0];
    }
    let around: [f32; 3] = Ball.sample_around([0.0, x, 1.0], &mut rng);
    let flat: [f32; 2] = Disk.sample(&mut rng);
    sum += around[0] + flat[0] + Lambert.unwarp_direction([x, sum, 1.0])[1];
    sum +=
        Lambert.warp_direction([x, sum])[0] + balance_heuristic(x, sum) + power_heuristic(x, sum);
    if cfg!(planted) {
        sum = (f64::from(sum) + 0.1) as f32;
    }
    sum
}
