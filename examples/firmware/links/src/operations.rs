//! Calls to the library, each result of which the image's result depends on.
#![allow(dead_code)] // which ones are used, COSLOBE_CALLS says

use core::convert::Infallible;
use coslobe::rand_core::TryRng;
use coslobe::*;

/// A small generator.
pub(crate) struct Words(pub(crate) u32);

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

/// A number type by an f32's value, and back.
pub(crate) trait Number: Real {
    fn of(x: f32) -> Self;
    fn to(self) -> f32;
}

impl Number for f32 {
    fn of(x: f32) -> Self {
        x
    }
    fn to(self) -> f32 {
        self
    }
}

impl Number for Fast<f32> {
    fn of(x: f32) -> Self {
        Fast(x)
    }
    fn to(self) -> f32 {
        self.0
    }
}

impl Number for f64 {
    fn of(x: f32) -> Self {
        x.into()
    }
    fn to(self) -> f32 {
        self as f32
    }
}

impl Number for Precise<f32> {
    fn of(x: f32) -> Self {
        Precise(x)
    }
    fn to(self) -> f32 {
        self.0
    }
}

impl Number for Precise<f64> {
    fn of(x: f32) -> Self {
        Precise(x.into())
    }
    fn to(self) -> f32 {
        self.0 as f32
    }
}

/// A planar law's sampler alone.
pub(crate) fn planar_sampler<T: Number>(law: impl Planar<T>, rng: &mut Words) -> f32 {
    let d = law.sample(rng);
    (d[0] + d[1]).to()
}

/// A spatial law's sampler alone.
pub(crate) fn spatial_sampler<T: Number>(law: impl Spatial<T>, rng: &mut Words) -> f32 {
    let d = law.sample(rng);
    (d[0] + d[1] + d[2]).to()
}

/// `CosPower`'s sampler alone.
pub(crate) fn power_sampler<T: Number>(x: f32, rng: &mut Words) -> f32 {
    CosPower::new(T::of(x)).map_or(0.0, |law| spatial_sampler(law, rng))
}

/// Every operation of every law, and of points, frames and weights.
pub(crate) fn everything<T: Number>(x: f32, rng: &mut Words) -> f32 {
    let (x, one) = (T::of(x), T::of(1.0));
    let mut sum = law(&Disk, x)
        + law(&CircleShell, x)
        + law(&CircleArc, x)
        + law(&Ball, x)
        + law(&SphereShell, x)
        + law(&Lambert, x);
    if let Ok(power) = CosPower::new(x) {
        let d = power.sample(rng);
        sum = sum + law(&power, x) + d[0] + power.pdf_solid_angle(x);
    }
    if let Ok(rho) = Radius::new(x) {
        sum = sum + point(&Ball, rho, x, rng) + point(&SphereShell, rho, x, rng);
        sum = sum + point(&Lambert, rho, x, rng) + Disk.sample_point(rho, rng)[0];
    }
    if let Ok(frame) = Frame::new([x, sum, one]) {
        sum = sum + frame.to_local([one, x, sum])[0] + frame.to_world([one, x, sum])[0];
    }
    let around: [T; 3] = Ball.sample_around([one - one, x, one], rng);
    let flat: [T; 2] = Disk.sample(rng);
    sum = sum + around[0] + flat[0] + Lambert.unwarp_direction([x, sum, one])[1];
    sum = sum + Lambert.warp_direction([x, sum])[0];
    (sum + balance_heuristic(x, sum) + power_heuristic(x, sum)).to()
}

fn law<T: Real>(law: &impl Law<T>, x: T) -> T {
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
