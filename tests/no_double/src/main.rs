//! Every `f32` and `Fast<f32>` operation in one image. It links only if no panic is reachable, since the
//! panic handler calls a symbol that exists nowhere, and `check` refuses it if a soft-double routine is
//! linked. `--cfg planted` adds one sum in `f64`, which the check must catch. `--cfg precise` is the image
//! of the `Precise` types instead, which compute in `f64`: that it links shows that they cannot panic.
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

fn every_operation<T: Real>(law: &impl Law<T>, x: T) -> T {
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

fn point<T: Real>(
    law: &(impl Tangent<T> + SpatialPoint<T>),
    rho: Radius<T>,
    x: T,
    rng: &mut Words,
) -> T {
    let at = law.warp(x);
    law.point_density(rho, at, x) + law.ln_point_density(rho, at, x) + law.sample_point(rho, rng)[0]
}

fn checked<T: Real, S: check::Subject>(mut check: check::Check<S>, one: T, rng: &mut Words) -> T {
    check.run(rng, check::SAMPLES);
    match check.verdict(check::Alarm::OneInBillion) {
        Ok(_) => one,
        Err(_) => -one,
    }
}

/// A number that depends on every operation.
fn image<T: Real>(x: T, one: T, rng: &mut Words) -> T {
    let mut sum = every_operation(&Disk, x)
        + every_operation(&CircleShell, x)
        + every_operation(&CircleArc, x)
        + every_operation(&Ball, x)
        + every_operation(&SphereShell, x)
        + every_operation(&Lambert, x);
    if let Ok(law) = CosPower::new(x) {
        let d = law.sample(rng);
        sum = sum + every_operation(&law, x) + d[0] + law.pdf_solid_angle(x);
    }
    if let Ok(rho) = Radius::new(x) {
        sum = sum + point(&Ball, rho, x, rng) + point(&SphereShell, rho, x, rng);
        sum = sum + point(&Lambert, rho, x, rng) + Disk.sample_point(rho, rng)[0];
    }
    if let Ok(frame) = Frame::new([x, sum, one]) {
        sum = sum + frame.to_local([one, x, sum])[0] + frame.to_world([one, x, sum])[0];
    }
    sum = sum + checked(check::spatial::<T, _>(Lambert), one, rng);
    sum = sum + checked(check::planar::<T, _>(Disk), one, rng);
    let around: [T; 3] = Ball.sample_around([one - one, x, one], rng);
    let flat: [T; 2] = Disk.sample(rng);
    sum = sum + around[0] + flat[0] + Lambert.unwarp_direction([x, sum, one])[1];
    sum + Lambert.warp_direction([x, sum])[0] + balance_heuristic(x, sum) + power_heuristic(x, sum)
}

/// The image's entry.
#[unsafe(no_mangle)]
pub extern "C" fn _start(x: f32, seed: u32) -> f32 {
    let rng = &mut Words(seed);
    if cfg!(precise) {
        let double = image(Precise(f64::from(x)), Precise(1.0), rng).0;
        return image(Precise(x), Precise(1.0), rng).0 + double as f32;
    }
    let mut sum = image(x, 1.0, rng) + image(Fast(x), Fast(1.0), rng).0;
    if cfg!(planted) {
        sum = (f64::from(sum) + 0.1) as f32;
    }
    sum
}
