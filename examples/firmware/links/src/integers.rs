//! Calls to the laws in integers, each result of which the image's result depends on.

use crate::operations::{Words, sound};
use ::fixed::traits::Fixed as Format;
use ::fixed::types::{I0F16, I0F32, I1F15, I1F31, I16F0, I32F0, U0F16, U0F32, U16F16};
use coslobe::integers::{
    CosPower, Fixed16Law, Fixed16Planar, Fixed16Spatial, FixedFrame, FixedLaw, FixedPlanar,
    FixedRadius, FixedSpatial,
};
use coslobe::{Disk, Fixed, Fixed16, Lambert, self_test};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};

/// A sampler in fixed point alone.
pub fn fixed_sampler<L: FixedLaw>(law: L, rng: &mut Words) -> u32
where
    L::Direction: AsRef<[I1F31]>,
{
    let d = Fixed(law).sample(rng);
    d.as_ref().iter().fold(0, |sum, c| sum ^ c.to_bits() as u32)
}

/// `CosPower`'s sampler in fixed point alone.
pub fn fixed_power_sampler(x: u32, rng: &mut Words) -> u32 {
    fixed_sampler(fixed_power(x), rng)
}

fn fixed_power(x: u32) -> CosPower {
    CosPower::new(U16F16::from_bits(x))
}

/// Every operation in fixed point, and checks of it.
pub fn fixed_everything(x: u32, rng: &mut Words) -> u32 {
    let mut all = InFixed { x, rng, sum: 0 };
    every_integer_law(&mut all);
    all.power(fixed_power(x));
    let sum = all.sum;
    sum ^ u32::from(sound(self_test::fixed(Fixed(Disk)), rng))
        ^ u32::from(sound(self_test::fixed(Fixed(Lambert)), rng))
        ^ u32::from(sound(self_test::fixed(Fixed(fixed_power(x))), rng))
}

struct InFixed<'a> {
    x: u32,
    rng: &'a mut Words,
    sum: u32,
}

impl InFixed<'_> {
    fn space(&mut self, law: impl FixedSpatial) {
        let component = I1F31::from_bits(self.x as i32);
        let (law, normal) = (Fixed(law), [component, I1F31::ZERO, I1F31::MAX]);
        let frame = FixedFrame::new(normal).unwrap_or(FixedFrame::from_unit(normal));
        let d = law.sample_around_with_density(normal, self.rng).direction;
        let u = law.unwarp_direction(frame.to_local(d));
        let [x, y, z] = law.warp_direction(u).map(|c| c.to_bits() as u32);
        let at_angle = law.pdf_solid_angle(I0F32::from_bits(self.x as i32));
        self.sum ^= x ^ y ^ z ^ u32::from(at_angle > 0);
    }
}

impl IntegerVisitor for InFixed<'_> {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        self.sum ^= fixed_law(law, self.x, self.rng);
        let Ok(rho) = FixedRadius::new(I32F0::from_bits(self.x as i32)) else {
            return;
        };
        let (law, v) = (Fixed(law), U0F32::from_bits(self.x));
        let at = law.warp(v);
        let r = law.distance(rho, at, v) ^ law.sample_distance(rho, at, self.rng);
        self.sum ^= r.to_bits() as u32;
    }
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, law: L) {
        self.law(law);
        if let Ok(rho) = FixedRadius::new(I32F0::from_bits(self.x as i32)) {
            self.sum ^= Fixed(law).sample_point(rho, self.rng)[0].to_bits() as u32;
        }
        self.sum ^= Fixed(law).sample_with_density(self.rng).density.to_bits();
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        self.law(law);
        self.space(law);
        if let Ok(rho) = FixedRadius::new(I32F0::from_bits(self.x as i32)) {
            self.sum ^= Fixed(law).sample_point(rho, self.rng)[0].to_bits() as u32;
        }
    }
    fn power(&mut self, law: CosPower) {
        self.sum ^= fixed_law(law, self.x, self.rng);
        self.space(law);
    }
}

fn fixed_law<L>(law: L, x: u32, rng: &mut Words) -> u32
where
    L: FixedLaw<Density: Format<Bits = u32>>,
    L::Direction: AsRef<[I1F31]>,
{
    let (fixed, p, theta) = (Fixed(law), U0F32::from_bits(x), I0F32::from_bits(x as i32));
    let (a, b) = (fixed.warp(p), fixed.warp_sf(p));
    let unsigned = fixed.pdf(theta).to_bits()
        ^ fixed.cdf(theta).to_bits()
        ^ fixed.sf(theta).to_bits()
        ^ fixed.unwarp(a).to_bits()
        ^ fixed.unwarp_sf(b).to_bits()
        ^ fixed.density(a).to_bits()
        ^ fixed.lambert_weight(a).to_bits();
    let signed = fixed.quantile(p).to_bits() ^ fixed.isf(p).to_bits() ^ b.sin.to_bits();
    unsigned ^ signed as u32 ^ fixed_sampler(law, rng)
}

/// A sampler in 16 bits alone.
pub fn fixed16_sampler<L>(law: L, rng: &mut Words) -> u32
where
    L: Fixed16Law<Direction: AsRef<[I1F15]>>,
{
    let d = Fixed16(law).sample(rng);
    d.as_ref().iter().fold(0, |sum, c| sum ^ c.to_bits() as u32)
}

/// Every operation in 16 bits.
pub fn fixed16_everything(x: u32, rng: &mut Words) -> u32 {
    let mut all = InFixed16 { x, rng, sum: 0 };
    every_integer_law(&mut all);
    all.sum
}

struct InFixed16<'a> {
    x: u32,
    rng: &'a mut Words,
    sum: u32,
}

impl InFixed16<'_> {
    fn radius(&self) -> Option<FixedRadius<I16F0>> {
        FixedRadius::new(I16F0::from_bits(self.x as i16)).ok()
    }
}

impl IntegerVisitor for InFixed16<'_> {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        self.sum ^= fixed16_law(law, self.x, self.rng);
        let (law, v) = (Fixed16(law), U0F16::from_bits(self.x as u16));
        if let Some(rho) = self.radius() {
            let at = law.warp(v);
            let r = law.distance(rho, at, v) ^ law.sample_distance(rho, at, self.rng);
            self.sum ^= r.to_bits() as u32;
        }
    }
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, law: L) {
        self.law(law);
        if let Some(rho) = self.radius() {
            self.sum ^= Fixed16(law).sample_point(rho, self.rng)[0].to_bits() as u32;
        }
        let density = Fixed16(law).sample_with_density(self.rng).density;
        self.sum ^= u32::from(density.to_bits());
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        self.law(law);
        let component = I1F15::from_bits(self.x as i16);
        let (law, normal) = (Fixed16(law), [component, I1F15::ZERO, I1F15::MAX]);
        let frame = FixedFrame::new(normal).unwrap_or(FixedFrame::from_unit(normal));
        let d = law.sample_around_with_density(normal, self.rng).direction;
        let u = law.unwarp_direction(frame.to_local(d));
        let [x, y, z] = law.warp_direction(u).map(|c| c.to_bits() as u32);
        let at_angle = law.pdf_solid_angle(I0F16::from_bits(self.x as i16));
        self.sum ^= x ^ y ^ z ^ u32::from(at_angle > 0);
        if let Some(rho) = self.radius() {
            self.sum ^= law.sample_point(rho, self.rng)[0].to_bits() as u32;
        }
    }
}

fn fixed16_law<L>(law: L, x: u32, rng: &mut Words) -> u32
where
    L: Fixed16Law<Direction: AsRef<[I1F15]>>,
{
    let short = Fixed16(law);
    let (p, theta) = (U0F16::from_bits(x as u16), I0F16::from_bits(x as i16));
    let (a, b) = (short.warp(p), short.warp_sf(p));
    let unsigned = short.pdf(theta).to_bits()
        ^ short.cdf(theta).to_bits()
        ^ short.sf(theta).to_bits()
        ^ short.unwarp(a).to_bits()
        ^ short.unwarp_sf(b).to_bits()
        ^ short.density(a).to_bits();
    let weight = short.lambert_weight(a).to_bits();
    let signed = short.quantile(p).to_bits() ^ short.isf(p).to_bits() ^ b.sin.to_bits();
    u32::from(unsigned) ^ weight ^ signed as u32 ^ fixed16_sampler(law, rng)
}
