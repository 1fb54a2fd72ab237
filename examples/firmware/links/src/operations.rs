//! Calls to the library, each result of which the image's result depends on.

use core::convert::Infallible;
use coslobe::rand_core::TryRng;
use coslobe::*;

/// A small generator.
pub struct Words(pub u32);

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

/// A number type by a word, and back.
pub trait Number: Real {
    fn of(x: u32) -> Self;
    fn to(self) -> u32;
}

impl Number for f32 {
    fn of(x: u32) -> Self {
        f32::from_bits(x)
    }
    fn to(self) -> u32 {
        self.to_bits()
    }
}

impl Number for Fast<f32> {
    fn of(x: u32) -> Self {
        Fast(f32::of(x))
    }
    fn to(self) -> u32 {
        self.0.to()
    }
}

impl Number for f64 {
    fn of(x: u32) -> Self {
        f64::from_bits(u64::from(x) << 32)
    }
    fn to(self) -> u32 {
        (self.to_bits() >> 32) as u32 ^ self.to_bits() as u32
    }
}

impl<T> Number for Precise<T>
where
    T: Number,
    Precise<T>: Real,
{
    fn of(x: u32) -> Self {
        Precise(T::of(x))
    }
    fn to(self) -> u32 {
        self.0.to()
    }
}

/// A planar law's sampler alone.
pub fn planar_sampler<T: Number>(law: impl Planar<T>, rng: &mut Words) -> u32 {
    let d = law.sample(rng);
    (d[0] + d[1]).to()
}

/// A spatial law's sampler alone.
pub fn spatial_sampler<T: Number>(law: impl Spatial<T>, rng: &mut Words) -> u32 {
    let d = law.sample(rng);
    (d[0] + d[1] + d[2]).to()
}

/// What a Cortex-M0 needs a routine for.
pub fn long_product(x: u32, rng: &mut Words) -> u32 {
    ((u64::from(x) * u64::from(rng.0)) >> 32) as u32
}

/// `CosPower`'s sampler alone.
pub fn power_sampler<T: Number>(x: u32, rng: &mut Words) -> u32 {
    CosPower::new(T::of(x)).map_or(0, |law| spatial_sampler(law, rng))
}

/// Every operation of every law, and of points, frames and weights.
pub fn everything<T: Number>(x: u32, rng: &mut Words) -> u32 {
    let (x, one) = (T::of(x), T::of(x ^ 1));
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
    if sound(self_test::spatial::<T, _>(Lambert), rng) ^ sound(self_test::planar::<T, _>(Disk), rng)
    {
        sum = sum + one;
    }
    let around: [T; 3] = Ball.sample_around([sum, x, one], rng);
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

pub(crate) fn sound<S: self_test::Subject>(mut test: self_test::Test<S>, rng: &mut Words) -> bool {
    test.run(rng, self_test::SAMPLES);
    test.verdict(self_test::Alarm::OneInBillion).is_ok()
}

fn point<T: Real>(law: &impl SpatialPoint<T>, rho: Radius<T>, x: T, rng: &mut Words) -> T {
    let at = law.warp(x);
    law.point_density(rho, at, x) + law.ln_point_density(rho, at, x) + law.sample_point(rho, rng)[0]
}

/// One pixel of a small scene, which lies at the address `x`: the shader without the scene's
/// contents.
pub fn shaded<S: scenes::Small>(x: u32, rng: &mut Words) -> u32 {
    // SAFETY: none is needed, since the image is not meant to run.
    let scene = unsafe { &*(x as *const shade_core::Scene<S::World>) };
    scenes::words::<S>(scene, (rng.0 as u16, (rng.0 >> 16) as u16))
}
