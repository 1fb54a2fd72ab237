//! `fixed`: the laws in integers as subjects of the test, which stays integer throughout.

use super::{Invalid, Place, Subject, Test};
use crate::CosSin;
use crate::integers::{Component, Format, Formulas, Integers};
use ::fixed::traits::Fixed;
use rand_core::Rng;

/// The crate's sampler of a law in integers, `I` = `Fixed<L>` or `Fixed16<L>`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InFixed<I> {
    law: I,
}

/// A test of a law in integers, of 32 bits or 16, in the plane or in space.
///
/// ```
/// use coslobe::{Disk, Fixed, Fixed16, Lambert, self_test::{self, Alarm}};
/// let mut test = self_test::fixed(Fixed(Disk));
/// test.run(&mut rand_pcg::Pcg32::new(2024, 1), self_test::SAMPLES);
/// test.verdict(Alarm::OneInBillion)?;
/// let mut test = self_test::fixed(Fixed16(Lambert));
/// test.run(&mut rand_pcg::Pcg32::new(2024, 1), self_test::SAMPLES);
/// test.verdict(Alarm::OneInBillion)?;
/// # Ok::<(), coslobe::self_test::Fault>(())
/// ```
pub fn fixed<F: Format, L: Formulas<F>>(law: Integers<F, L>) -> Test<InFixed<Integers<F, L>>>
where
    InFixed<Integers<F, L>>: Subject,
{
    Test::new(InFixed { law })
}

/// A direction in the plane or in space. Sealed.
pub trait Components: Copy {
    /// The direction's pair in Q31, the square of its length in Q62, and its sector.
    fn polar(self) -> (CosSin<i32>, u64, Option<u8>);
}

fn square(x: i32) -> u64 {
    let x = u64::from(x.unsigned_abs());
    x * x
}

impl<C: Component> Components for [C; 2] {
    fn polar(self) -> (CosSin<i32>, u64, Option<u8>) {
        let [sin, cos] = self.map(C::Format::of_component);
        (CosSin { cos, sin }, square(sin) + square(cos), None)
    }
}

impl<C: Component> Components for [C; 3] {
    fn polar(self) -> (CosSin<i32>, u64, Option<u8>) {
        let [x, cos, z] = self.map(C::Format::of_component);
        let flat = square(x) + square(z);
        let sin = i32::try_from(flat.isqrt()).unwrap_or(i32::MAX);
        (CosSin { cos, sin }, flat + square(cos), Some(sector(x, z)))
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

impl<F: Format, L: Formulas<F>> Subject for InFixed<Integers<F, L>>
where
    L::Direction: Components,
{
    type Sample = L::Direction;

    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        self.law.sample(rng)
    }

    fn place(&self, sample: &L::Direction) -> Result<Place, Invalid> {
        let (at, square, sector) = sample.polar();
        if square.abs_diff(1 << 62) > F::LENGTH_SLACK {
            return Err(Invalid::Length);
        }
        if at.cos <= 0 {
            return Err(Invalid::Support);
        }
        if self.law.0.density(at) <= <L::Density as Fixed>::ZERO {
            return Err(Invalid::Density);
        }
        let tails = self.law.0.unwarp_tails(at);
        Ok(Place {
            tail: tails.lower.min(tails.upper) >> 1,
            upper: tails.upper <= tails.lower,
            sector,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{InFixed, sector};
    use crate::self_test::{InPlane, Subject, subject};
    use crate::{CircleArc, Fixed};
    use ::fixed::types::I1F31;

    #[test]
    fn sectors_are_those_of_the_other_number_types() {
        // Borders of sectors are among them: a diagonal, and 169/408.
        for x in [-408, -169, -2, -1, 0, 1, 2, 169, 408i16] {
            for z in [-408, -169, -3, -1, 0, 1, 3, 169, 408i16] {
                let expected = subject::sector(f32::from(x), f32::from(z));
                assert_eq!(sector(x.into(), z.into()), expected, "({x}, {z})");
            }
        }
    }

    #[test]
    fn the_axis_is_on_the_side_that_it_has_in_the_other_number_types() {
        let axis = [I1F31::ZERO, I1F31::MAX];
        let place = InFixed {
            law: Fixed(CircleArc),
        }
        .place(&axis);
        let expected = InPlane::<f32, _>::new(CircleArc).place(&[0.0, 1.0]);
        assert_eq!(place, expected);
    }
}
