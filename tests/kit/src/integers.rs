//! Laws in fixed point.

use crate::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use crate::input::mix;
use crate::{Laws, Named, Sink, Subject, Visitor};
use coslobe::integers::{CosPower, FixedLaw};
use coslobe::{CosSin, Fixed};
use fixed::traits::Fixed as Format;
use fixed::types::{I0F32, I1F31, U0F32};
use rand_pcg::Pcg32;

/// The number type of [`coslobe::Fixed`].
pub struct Integers;

impl Laws for Integers {
    fn each(visitor: &mut impl Visitor) {
        every_integer_law(&mut Subjects(visitor));
    }
}

struct Subjects<'a, V>(&'a mut V);

impl<V: Visitor> IntegerVisitor for Subjects<'_, V> {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        self.0.visit(&integers(law));
    }
    fn power(&mut self, law: CosPower) {
        self.0.visit(&integers(law));
    }
}

/// A law in fixed point.
pub fn integers<L>(law: L) -> impl Subject
where
    L: FixedLaw<Density: Format<Bits = u32>> + Named,
    L::Direction: AsRef<[I1F31]>,
{
    InIntegers(Fixed(law))
}

struct InIntegers<L>(Fixed<L>);

impl<L> Subject for InIntegers<L>
where
    L: FixedLaw<Density: Format<Bits = u32>> + Named,
    L::Direction: AsRef<[I1F31]>,
{
    const LAW: &'static str = L::ID.name();
    const NUMBER: &'static str = "Fixed";

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
        sink.take("x", u64::from(x));
        sink.take("y", u64::from(y));
        let (p, theta) = (U0F32::from_bits(x), I0F32::from_bits(x as i32));
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
            cos: I1F31::from_bits(x as i32),
            sin: I1F31::from_bits(y as i32),
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

fn word(signed: i32) -> u64 {
    u64::from(signed as u32)
}

/// In turn: any two words; words within 2¹⁶ of 0, of eighths of a turn and of the signs' ends.
pub(crate) fn input(index: u32) -> (u32, u32) {
    let (a, b) = (mix(index, 0), mix(index, 1));
    let beside = |w: u64| {
        let (end, step) = (
            (w as u32 & 7) << 29,
            (w >> 32) as u32 >> (16 + (w >> 8 & 15)),
        );
        if w >> 3 & 1 == 0 {
            end.wrapping_add(step)
        } else {
            end.wrapping_sub(step)
        }
    };
    match index % 2 {
        0 => (a as u32, b as u32),
        _ => (beside(a), beside(b)),
    }
}
