//! `fixed`: the laws in integers as subjects of the self-test, which stays integer throughout.

use super::{Invalid, Place, Subject, Test};
use crate::fixed::FixedLaw;
use crate::{CosSin, Fixed};
use ::fixed::types::I1F31;
use rand_core::Rng;

/// How far the square of a length may be from 1, in Q62: 2⁻²⁶, of components that are off by 4
/// units of Q31.
const SLACK: u64 = 1 << 36;

/// The crate's sampler of a law in integers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InFixed<L> {
    law: Fixed<L>,
}

/// A test of a law in integers, in the plane or in space.
///
/// ```
/// use coslobe::{Disk, Fixed, self_test::{self, Alarm}};
/// let mut test = self_test::fixed(Fixed(Disk));
/// test.run(&mut rand_pcg::Pcg32::new(2024, 1), self_test::SAMPLES);
/// test.verdict(Alarm::OneInBillion)?;
/// # Ok::<(), coslobe::self_test::Fault>(())
/// ```
pub fn fixed<L: FixedLaw>(law: Fixed<L>) -> Test<InFixed<L>>
where
    InFixed<L>: Subject,
{
    Test::new(InFixed { law })
}

/// A direction in the plane or in space. Sealed.
pub trait Components: Copy {
    /// The direction's pair, the square of its length in Q62, and its sector.
    fn polar(self) -> (CosSin<I1F31>, u64, Option<u8>);
}

fn square(x: I1F31) -> u64 {
    let x = u64::from(x.to_bits().unsigned_abs());
    x * x
}

impl Components for [I1F31; 2] {
    fn polar(self) -> (CosSin<I1F31>, u64, Option<u8>) {
        let [sin, cos] = self;
        (CosSin { cos, sin }, square(sin) + square(cos), None)
    }
}

impl Components for [I1F31; 3] {
    fn polar(self) -> (CosSin<I1F31>, u64, Option<u8>) {
        let [x, cos, z] = self;
        let flat = square(x) + square(z);
        let sin = I1F31::from_bits(i32::try_from(flat.isqrt()).unwrap_or(i32::MAX));
        let sector = sector(x.to_bits(), z.to_bits());
        (CosSin { cos, sin }, flat + square(cos), Some(sector))
    }
}

/// As the sectors of the other number types.
fn sector(x: i32, z: i32) -> u8 {
    let (a, b) = (x.unsigned_abs(), z.unsigned_abs());
    let steep = b > a;
    let outer = u64::from(a.min(b)) * 408 > u64::from(a.max(b)) * 169;
    let bit = |set, i| u8::from(set) << i;
    bit(x < 0, 3) | bit(z < 0, 2) | bit(steep, 1) | bit(outer, 0)
}

impl<L: FixedLaw> Subject for InFixed<L>
where
    L::Direction: Components,
    L::Density: Default + PartialOrd,
{
    type Sample = L::Direction;

    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        self.law.sample(rng)
    }

    fn place(&self, sample: &L::Direction) -> Result<Place, Invalid> {
        let (at, square, sector) = sample.polar();
        if square.abs_diff(1 << 62) > SLACK {
            return Err(Invalid::Length);
        }
        if at.cos <= I1F31::ZERO {
            return Err(Invalid::Support);
        }
        if self.law.density(at) <= L::Density::default() {
            return Err(Invalid::Density);
        }
        let (lower, upper) = (self.law.unwarp(at), self.law.unwarp_sf(at));
        Ok(Place {
            tail: lower.min(upper).to_bits() >> 1,
            upper: upper < lower,
            sector,
        })
    }
}
