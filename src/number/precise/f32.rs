//! `Precise<f32>`: `f64` with a rounding test, double-double where it cannot decide.

use super::Precise;
use crate::arithmetic::double::Double;
use crate::arithmetic::double::nearest::Grid;
use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::f64::power_of_two;
use crate::arithmetic::native::turn::at_quadrant;
use crate::arithmetic::native::uniform::f32::parts_of_turn;
use crate::number::Real;
use crate::number::tier::{Code, Margin, Tier};
use crate::scalar::Scalar;
use crate::{CosSin, Tails};
use rand_core::TryRng;

impl Holds<Precise<f32>> for f64 {
    #[inline(always)]
    fn from_number(x: Precise<f32>) -> f64 {
        f64::from(x.0)
    }
}

impl Holds<Precise<f32>> for Double {
    #[inline(always)]
    fn from_number(x: Precise<f32>) -> Double {
        Double::from_f64(f64::from(x.0))
    }
}

/// The `f32` nearest to hi + lo.
fn nearest_f32(x: Double) -> f32 {
    if x.hi.is_normal() {
        f32::from_bits(Grid::F32.nearest(x, 0) as u32).copysign(x.hi as f32)
    } else {
        x.hi as f32
    }
}

/// `y` as an `f32`, if all that lies within the error of `f64`'s formulas around it rounds alike.
///
/// Those are within 4 ulp, 2⁻⁵⁰ of the result; the test allows twice that.
#[inline(always)]
fn decided(y: f64, margin: Margin) -> Option<f32> {
    let scale = match margin {
        Margin::OfOne if y.abs() < 1.0 => 1.0,
        _ => y.abs(),
    };
    let error = scale * f64::EPSILON * 8.0;
    let (below, above) = ((y - error) as f32, (y + error) as f32);
    (below.to_bits() == above.to_bits()).then_some(below)
}

#[cold]
fn decide<const N: usize>(accurate: impl FnOnce() -> [Double; N]) -> [Precise<f32>; N] {
    accurate().map(|x| Precise(nearest_f32(x)))
}

impl Real for Precise<f32> {}

impl From<Precise<f32>> for f64 {
    #[inline(always)]
    fn from(x: Precise<f32>) -> f64 {
        f64::from(x.0)
    }
}

impl Tier for Precise<f32> {
    type Quick = f64;
    type Accurate = Double;
    type Base = f64;

    const UNIT_SLACK: f64 = power_of_two(-18);
    type TailBits = u64;
    type TurnBits = u32;

    #[inline]
    fn rounded<const N: usize>(
        margin: Margin,
        quick: impl FnOnce() -> [f64; N],
        accurate: impl FnOnce() -> [Double; N],
    ) -> [Self; N] {
        if margin == Margin::Unbounded {
            return decide(accurate);
        }
        let mut out = [Self::ZERO; N];
        for (out, y) in out.iter_mut().zip(quick()) {
            match decided(y, margin) {
                Some(x) => *out = Precise(x),
                None => return decide(accurate),
            }
        }
        out
    }

    #[inline]
    fn to_base(self) -> f64 {
        f64::from(self.0)
    }

    #[inline]
    fn from_base(x: f64) -> Self {
        Precise(x as f32)
    }

    #[inline]
    fn try_draw_tail_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
        f32::try_draw_tail_bits(rng)
    }

    #[inline]
    fn try_draw_turn_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        f32::try_draw_turn_bits(rng)
    }

    #[inline]
    fn nearer_from_bits(bits: u64, code: Code) -> (Self, bool) {
        let (p, is_upper) = f32::nearer_from_bits(bits, code);
        (Precise(p), is_upper)
    }

    #[inline]
    fn tails_from_half(bits: u32, code: Code) -> Tails<Self> {
        Tails::from_array(f32::tails_from_half(bits, code).to_array().map(Precise))
    }

    #[inline]
    fn quick_turn_from_bits(bits: u32, _: Code) -> CosSin<f64> {
        let (quadrant, x) = turn(bits);
        at_quadrant(quadrant, x)
    }

    #[inline]
    fn accurate_turn_from_bits(bits: u32, _: Code) -> CosSin<Double> {
        let (quadrant, x) = turn(bits);
        Double::at_quadrant(quadrant, Double::from_f64(x))
    }
}

/// (q, x): a uniform azimuth as q quarters and x turns, exactly.
#[inline(always)]
fn turn(bits: u32) -> (u32, f64) {
    let (quadrant, part) = parts_of_turn(bits);
    (quadrant, f64::from(part) * power_of_two(-33))
}
