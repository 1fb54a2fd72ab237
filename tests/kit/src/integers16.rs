//! Laws in fixed point of 16 bits.

use crate::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use crate::integers::input;
use crate::{Laws, Named, Sink, Subject, Visitor};
use coslobe::integers::Fixed16Law;
use coslobe::{CosSin, Fixed16};
use fixed::types::{I0F16, I1F15, U0F16};
use rand_pcg::Pcg32;

/// The number type of [`coslobe::Fixed16`].
pub struct Integers16;

impl Laws for Integers16 {
    fn each(visitor: &mut impl Visitor) {
        every_integer_law(&mut Subjects(visitor));
    }
}

struct Subjects<'a, V>(&'a mut V);

impl<V: Visitor> IntegerVisitor for Subjects<'_, V> {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        self.0.visit(&integers16(law));
    }
}

/// A law in fixed point of 16 bits.
pub fn integers16<L>(law: L) -> impl Subject
where
    L: Fixed16Law<Direction: AsRef<[I1F15]>> + Named,
{
    InIntegers16(Fixed16(law))
}

struct InIntegers16<L>(Fixed16<L>);

impl<L> Subject for InIntegers16<L>
where
    L: Fixed16Law<Direction: AsRef<[I1F15]>> + Named,
{
    const LAW: &'static str = L::ID.name();
    const NUMBER: &'static str = "Fixed16";

    #[inline]
    fn sample(&self, rng: &mut Pcg32, sink: &mut impl Sink) {
        for c in self.0.sample(rng).as_ref() {
            sink.take("sample", word(c.to_bits()));
        }
    }

    #[inline]
    fn evaluate(&self, index: u32, sink: &mut impl Sink) {
        let law = &self.0;
        let (x, y) = input(index);
        let (x, y) = ((x >> 16) as u16, (y >> 16) as u16);
        sink.take("x", u64::from(x));
        sink.take("y", u64::from(y));
        let (p, theta) = (U0F16::from_bits(x), I0F16::from_bits(x as i16));
        sink.take("pdf(x)", u64::from(law.pdf(theta).to_bits()));
        sink.take("cdf(x)", u64::from(law.cdf(theta).to_bits()));
        sink.take("sf(x)", u64::from(law.sf(theta).to_bits()));
        sink.take("quantile(x)", word(law.quantile(p).to_bits()));
        sink.take("isf(x)", word(law.isf(p).to_bits()));
        let (at, far) = (law.warp(p), law.warp_sf(p));
        sink.take("warp(x).cos", word(at.cos.to_bits()));
        sink.take("warp(x).sin", word(at.sin.to_bits()));
        sink.take("warp_sf(x).cos", word(far.cos.to_bits()));
        sink.take("warp_sf(x).sin", word(far.sin.to_bits()));
        // Any two words are safe; warp(x) is a direction.
        let any = CosSin {
            cos: I1F15::from_bits(x as i16),
            sin: I1F15::from_bits(y as i16),
        };
        let names = [
            ["density(warp(x))", "unwarp(warp(x))", "unwarp_sf(warp(x))"],
            ["density(x, y)", "unwarp(x, y)", "unwarp_sf(x, y)"],
        ];
        for (at, names) in [at, any].into_iter().zip(names) {
            sink.take(names[0], u64::from(law.density(at).to_bits()));
            sink.take(names[1], u64::from(law.unwarp(at).to_bits()));
            sink.take(names[2], u64::from(law.unwarp_sf(at).to_bits()));
        }
    }
}

fn word(signed: i16) -> u64 {
    u64::from(signed as u16)
}
