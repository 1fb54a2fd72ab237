//! The laws in integers of 16 bits.

use crate::Meter;
use crate::fixed::{pairs, probabilities, turns};
use coslobe::integers::{
    Fixed16Law, Fixed16Planar, Fixed16Spatial, Fixed16Tangent, FixedPlanar, FixedRadius,
    FixedSpatial,
};
use coslobe::{CosSin, Fixed16};
use fixed::types::{I0F16, I1F15, I16F0, U0F16, U16F16};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// Every operation of every law.
pub fn every_fixed16_law(meter: &mut Meter) {
    every_integer_law(&mut Counted(meter));
}

/// A lobe around a normal, which is an input as the law is.
fn around<L: Fixed16Spatial>(meter: &mut Meter, name: &'static str, law: L) {
    meter.law(name);
    let input = (Fixed16(law), [0.36, -0.48, 0.8].map(I1F15::from_num));
    meter.draw_as::<XorShiftRng, _, _>(
        "sample_around",
        &input,
        |(law, normal), rng| law.sample_around(*normal, rng),
        |_, _| <[I1F15; 3]>::default(),
    );
}

struct Counted<'a, 'm>(&'a mut Meter<'m>);

impl IntegerVisitor for Counted<'_, '_> {
    fn law<L: IntegerLaw>(&mut self, l: L) {
        law(self.0, L::ID.name(), &Fixed16(l), L::ID.planar());
    }
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, l: L) {
        self.law(l);
        point(self.0, &Fixed16(l));
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, l: L) {
        self.law(l);
        around(self.0, L::ID.name(), l);
        point(self.0, &Fixed16(l));
    }
}

/// A point, of a radius that is an input as the law is.
fn point<L, const N: usize>(meter: &mut Meter, law: &Fixed16<L>)
where
    L: Fixed16Law<Direction = [I1F15; N]> + Fixed16Tangent,
    [I16F0; N]: Default,
{
    let radius = FixedRadius::new(I16F0::from_bits(8_000)).expect("a radius");
    meter.draw_as::<XorShiftRng, _, _>(
        "sample_point",
        &(*law, radius),
        |(law, radius), rng| law.sample_point(*radius, rng),
        |_, _| <[I16F0; N]>::default(),
    );
}

fn law<L, D: Default>(meter: &mut Meter, name: &'static str, l: &Fixed16<L>, planar: bool)
where
    L: Fixed16Law<Direction = D>,
{
    let word = |_: &Fixed16<L>, x: I0F16| U0F16::from_bits(x.to_bits() as u16);
    let turn = |_: &Fixed16<L>, p: U0F16| I0F16::from_bits(p.to_bits() as i16);
    let (theta, at, p) = (turns(planar), pairs(planar), probabilities());
    meter.law(name);
    meter.call("pdf", l, &theta, Fixed16::pdf, word);
    meter.call("cdf", l, &theta, Fixed16::cdf, word);
    meter.call("sf", l, &theta, Fixed16::sf, word);
    let cos = |_: &Fixed16<L>, at: CosSin<I1F15>| U0F16::from_bits(at.cos.to_bits() as u16);
    meter.call("density", l, &at, Fixed16::density, cos);
    let weight = |_: &Fixed16<L>, at: CosSin<I1F15>| U16F16::from_bits(at.cos.to_bits() as u32);
    meter.call("lambert_weight", l, &at, Fixed16::lambert_weight, weight);
    meter.call("unwarp", l, &at, Fixed16::unwarp, cos);
    meter.call("unwarp_sf", l, &at, Fixed16::unwarp_sf, cos);
    let both = |_: &Fixed16<L>, p: U0F16| {
        let x = I1F15::from_bits(p.to_bits() as i16);
        CosSin { cos: x, sin: x }
    };
    meter.call("warp", l, &p, Fixed16::warp, both);
    meter.call("warp_sf", l, &p, Fixed16::warp_sf, both);
    meter.call("quantile", l, &p, Fixed16::quantile, turn);
    meter.call("isf", l, &p, Fixed16::isf, turn);
    meter.draw::<Pcg32, _, _>(l, Fixed16::sample, |_, _| D::default());
    meter.draw::<XorShiftRng, _, _>(l, Fixed16::sample, |_, _| D::default());
}
