//! The laws in integers of 16 bits.

use crate::Meter;
use crate::fixed::{pairs, probabilities, turns};
use coslobe::fixed::Fixed16Law;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed16, Lambert, SphereShell};
use fixed::types::{I0F16, I1F15, U0F16};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// Every operation of every law.
pub fn every_fixed16_law(meter: &mut Meter) {
    law(meter, "Disk", &Fixed16(Disk), true);
    law(meter, "CircleShell", &Fixed16(CircleShell), true);
    law(meter, "CircleArc", &Fixed16(CircleArc), true);
    law(meter, "Ball", &Fixed16(Ball), false);
    law(meter, "SphereShell", &Fixed16(SphereShell), false);
    law(meter, "Lambert", &Fixed16(Lambert), false);
}

/// A constant of a direction's type.
trait Zero {
    const ZERO: Self;
}

impl<const N: usize> Zero for [I1F15; N] {
    const ZERO: Self = [I1F15::ZERO; N];
}

fn law<L, D: Zero>(meter: &mut Meter, name: &'static str, l: &Fixed16<L>, planar: bool)
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
    meter.draw::<Pcg32, _, _>(l, Fixed16::sample, |_, _| D::ZERO);
    meter.draw::<XorShiftRng, _, _>(l, Fixed16::sample, |_, _| D::ZERO);
}
