//! The laws in integers.

use crate::Meter;
use crate::inputs::{COUNT, FROM_END, TAILS};
use crate::laws::EXPONENT;
use coslobe::integers::{
    CosPower, Fixed16Planar, Fixed16Spatial, FixedLaw, FixedPlanar, FixedRadius, FixedSpatial,
    FixedTangent,
};
use coslobe::{CosSin, Fixed};
use fixed::traits::Fixed as Format;
use fixed::types::{I0F32, I1F31, I32F0, U0F32, U16F16};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// Angles in turns from both ends of the support; of both signs in the plane.
pub(crate) fn turns<T: Format>(planar: bool) -> [T; COUNT] {
    core::array::from_fn(|i| {
        let d = FROM_END[i / 2] / core::f64::consts::TAU;
        let turn = if i % 2 == 0 { d } else { 0.25 - d };
        T::from_num(if planar && i % 4 >= 2 { -turn } else { turn })
    })
}

/// Unit vectors at those angles.
pub(crate) fn pairs<T: Format>(planar: bool) -> [CosSin<T>; COUNT] {
    crate::inputs::pairs::<f64>(planar).map(|at| CosSin {
        cos: T::saturating_from_num(at.cos),
        sin: T::saturating_from_num(at.sin),
    })
}

/// From both ends.
pub(crate) fn probabilities<T: Format>() -> [T; COUNT] {
    core::array::from_fn(|i| {
        let p = TAILS[i / 2];
        T::saturating_from_num(if i % 2 == 0 { p } else { 1.0 - p })
    })
}

/// Every operation of every law.
pub fn every_fixed_law(meter: &mut Meter) {
    every_integer_law(&mut Counted(meter));
    let power = CosPower::new(U16F16::from_num(EXPONENT));
    law(meter, "CosPower(20)", &Fixed(power), false);
    around(meter, "CosPower(20)", power);
}

/// A lobe around a normal, which is an input as the law is.
fn around<L: FixedSpatial>(meter: &mut Meter, name: &'static str, law: L) {
    meter.law(name);
    let input = (Fixed(law), [0.36, -0.48, 0.8].map(I1F31::from_num));
    meter.draw_as::<XorShiftRng, _, _>(
        "sample_around",
        &input,
        |(law, normal), rng| law.sample_around(*normal, rng),
        |_, _| <[I1F31; 3]>::default(),
    );
}

struct Counted<'a, 'm>(&'a mut Meter<'m>);

impl IntegerVisitor for Counted<'_, '_> {
    fn law<L: IntegerLaw>(&mut self, l: L) {
        law(self.0, L::ID.name(), &Fixed(l), L::ID.planar());
    }
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, l: L) {
        self.law(l);
        point(self.0, &Fixed(l));
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, l: L) {
        self.law(l);
        around(self.0, L::ID.name(), l);
        point(self.0, &Fixed(l));
    }
}

/// A point, of a radius that is an input as the law is.
fn point<L, const N: usize>(meter: &mut Meter, law: &Fixed<L>)
where
    L: FixedLaw<Direction = [I1F31; N]> + FixedTangent,
    [I32F0; N]: Default,
{
    let radius = FixedRadius::new(I32F0::from_bits(1 << 28)).expect("a radius");
    meter.draw_as::<XorShiftRng, _, _>(
        "sample_point",
        &(*law, radius),
        |(law, radius), rng| law.sample_point(*radius, rng),
        |_, _| <[I32F0; N]>::default(),
    );
}

fn law<L, D: Default>(meter: &mut Meter, name: &'static str, l: &Fixed<L>, planar: bool)
where
    L: FixedLaw<Density: Format<Bits = u32>, Direction = D>,
{
    let word = |_: &Fixed<L>, x: I0F32| U0F32::from_bits(x.to_bits() as u32);
    let density = |_: &Fixed<L>, x: I0F32| L::Density::from_bits(x.to_bits() as u32);
    let turn = |_: &Fixed<L>, p: U0F32| I0F32::from_bits(p.to_bits() as i32);
    let (theta, at, p) = (turns(planar), pairs(planar), probabilities());
    meter.law(name);
    meter.call("pdf", l, &theta, Fixed::pdf, density);
    meter.call("cdf", l, &theta, Fixed::cdf, word);
    meter.call("sf", l, &theta, Fixed::sf, word);
    let cos = |_: &Fixed<L>, at: CosSin<I1F31>| U0F32::from_bits(at.cos.to_bits() as u32);
    let density = |_: &Fixed<L>, at: CosSin<I1F31>| L::Density::from_bits(at.cos.to_bits() as u32);
    meter.call("density", l, &at, Fixed::density, density);
    let weight = |_: &Fixed<L>, at: CosSin<I1F31>| U16F16::from_bits(at.cos.to_bits() as u32);
    meter.call("lambert_weight", l, &at, Fixed::lambert_weight, weight);
    meter.call("unwarp", l, &at, Fixed::unwarp, cos);
    meter.call("unwarp_sf", l, &at, Fixed::unwarp_sf, cos);
    let both = |_: &Fixed<L>, p: U0F32| {
        let x = I1F31::from_bits(p.to_bits() as i32);
        CosSin { cos: x, sin: x }
    };
    meter.call("warp", l, &p, Fixed::warp, both);
    meter.call("warp_sf", l, &p, Fixed::warp_sf, both);
    meter.call("quantile", l, &p, Fixed::quantile, turn);
    meter.call("isf", l, &p, Fixed::isf, turn);
    meter.draw::<Pcg32, _, _>(l, Fixed::sample, |_, _| D::default());
    meter.draw::<XorShiftRng, _, _>(l, Fixed::sample, |_, _| D::default());
}
