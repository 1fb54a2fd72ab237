//! Fixed point: no word, pair or exponent may overflow, panic or leave its range.

use super::input::Words;
use coslobe::integers::{CosPower, FixedLaw, cos_sin};
use coslobe::{CosSin, Fixed};
use fixed::types::{I0F32, I1F31, U0F32, U16F16};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};

/// The promise: a unit vector to 4 units of Q31.
const UNITS: f64 = 4.0;
const Q31: f64 = 2147483648.0;
/// A quarter turn.
const QUARTER: i32 = 1 << 30;

/// Words: two arguments, then an exponent; all of them the generator.
pub fn check(data: &[u8]) {
    let mut words = Words::new(data);
    let (a, b) = (words.word(), words.word());
    let k = U16F16::from_bits(words.word() as u32);
    every_integer_law(&mut Check { a, b, data });
    law(Fixed(CosPower::new(k)), a, b, data);
    unit([
        cos_sin(I0F32::from_bits(a as i32)).cos,
        cos_sin(I0F32::from_bits(a as i32)).sin,
    ]);
}

struct Check<'a> {
    a: u64,
    b: u64,
    data: &'a [u8],
}

impl IntegerVisitor for Check<'_> {
    fn law<L: IntegerLaw>(&mut self, l: L) {
        law(Fixed(l), self.a, self.b, self.data);
    }
}

fn unit<const N: usize>(direction: [I1F31; N]) {
    let square: f64 = direction.iter().map(|&x| f64::from(x) * f64::from(x)).sum();
    assert!(
        (square.sqrt() - 1.0).abs() * Q31 <= UNITS,
        "{direction:?} has length {}",
        square.sqrt()
    );
}

fn law<L: FixedLaw>(law: Fixed<L>, a: u64, b: u64, data: &[u8])
where
    L::Direction: AsRef<[I1F31]>,
{
    for word in [a as u32, (a >> 32) as u32] {
        let p = U0F32::from_bits(word);
        for at in [law.warp(p), law.warp_sf(p)] {
            unit([at.cos, at.sin]);
            assert!(at.cos >= 0, "{at:?} at {p}");
        }
        for theta in [law.quantile(p), law.isf(p)] {
            assert!(theta.to_bits().abs() <= QUARTER, "{theta} at {p}");
        }
        let theta = I0F32::from_bits(word as i32);
        law.pdf(theta);
        sums_to_one(law.cdf(theta), law.sf(theta));
    }
    let (cos, sin) = (
        I1F31::from_bits(b as i32),
        I1F31::from_bits((b >> 32) as i32),
    );
    law.density(CosSin { cos, sin });
    law.unwarp(CosSin { cos, sin });
    law.unwarp_sf(CosSin { cos, sin });
    let mut words = Words::new(data);
    for _ in 0..4 {
        let direction = law.sample(&mut words);
        let direction = direction.as_ref();
        assert!(direction[1] > 0, "{direction:?} is not above the horizon");
        let mut padded = [I1F31::ZERO; 3];
        padded[..direction.len()].copy_from_slice(direction);
        unit(padded);
    }
}

/// Each is rounded by itself.
fn sums_to_one(cdf: U0F32, sf: U0F32) {
    let sum = u64::from(cdf.to_bits()) + u64::from(sf.to_bits());
    assert!(sum.abs_diff(1 << 32) <= 4, "{cdf} + {sf}");
}
