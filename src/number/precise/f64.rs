//! `Precise<f64>`: double-double, with an exponent of its own where `f64`'s would not reach.

use super::Precise;
use crate::arithmetic::double::Double;
use crate::arithmetic::double::nearest::{Grid, is_moderate};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::f64::power_of_two;
use crate::arithmetic::native::uniform::f64::parts_of_turn;
use crate::arithmetic::scaled::Scaled;
use crate::number::Real;
use crate::number::tier::{Code, Margin, Tier};
use crate::scalar::Scalar;
use crate::{CosSin, Tails};
use rand_core::TryRng;

impl Holds<Precise<f64>> for Double {
    /// NaN for what is too small or too large to be multiplied with all digits: as the laws give
    /// NaN for NaN, the quick result is then not taken.
    #[inline(always)]
    fn from_number(x: Precise<f64>) -> Double {
        Double::from_f64(if x.0 == 0.0 || is_moderate(x.0) {
            x.0
        } else {
            f64::NAN
        })
    }
}

impl Holds<Precise<f64>> for Scaled {
    fn from_number(x: Precise<f64>) -> Self {
        Self::new(Double::from_f64(x.0), 0)
    }
}

fn nearest_f64(x: Scaled) -> f64 {
    let hi = x.part.hi;
    if hi.is_finite() && hi != 0.0 {
        f64::from_bits(Grid::F64.nearest(x.part, x.exponent)).copysign(hi)
    } else {
        hi
    }
}

#[cold]
fn decide<const N: usize>(accurate: impl FnOnce() -> [Scaled; N]) -> [Precise<f64>; N] {
    accurate().map(|x| Precise(nearest_f64(x)))
}

impl Real for Precise<f64> {}

impl From<Precise<f64>> for f64 {
    #[inline(always)]
    fn from(x: Precise<f64>) -> f64 {
        x.0
    }
}

impl Tier for Precise<f64> {
    type Quick = Double;
    type Accurate = Scaled;
    type Base = f64;

    const UNIT_SLACK: f64 = power_of_two(-34);
    type TailBits = u128;
    type TurnBits = u64;

    #[inline]
    fn rounded<const N: usize>(
        _: Margin,
        quick: impl FnOnce() -> [Double; N],
        accurate: impl FnOnce() -> [Scaled; N],
    ) -> [Self; N] {
        let mut out = [Self::ZERO; N];
        for (out, y) in out.iter_mut().zip(quick()) {
            if !is_moderate(y.hi) {
                return decide(accurate);
            }
            *out = Precise(y.hi + y.lo);
        }
        out
    }

    #[inline]
    fn to_base(self) -> f64 {
        self.0
    }

    #[inline]
    fn from_base(x: f64) -> Self {
        Precise(x)
    }

    #[inline]
    fn try_draw_tail_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u128, R::Error> {
        f64::try_draw_tail_bits(rng)
    }

    #[inline]
    fn try_draw_turn_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
        f64::try_draw_turn_bits(rng)
    }

    #[inline]
    fn nearer_from_bits(bits: u128, code: Code) -> (Self, bool) {
        let (p, is_upper) = f64::nearer_from_bits(bits, code);
        (Precise(p), is_upper)
    }

    #[inline]
    fn tails_from_half(bits: u64, code: Code) -> Tails<Self> {
        Tails::from_array(f64::tails_from_half(bits, code).to_array().map(Precise))
    }

    #[inline]
    fn quick_turn_from_bits(bits: u64, _: Code) -> CosSin<Double> {
        let (quadrant, x) = turn(bits);
        Double::at_quadrant(quadrant, x)
    }

    #[inline]
    fn accurate_turn_from_bits(bits: u64, _: Code) -> CosSin<Scaled> {
        let (quadrant, x) = turn(bits);
        Scaled::at_quadrant(quadrant, Scaled::from_double(x))
    }
}

/// (q, x): a uniform azimuth as q quarters and x turns, exactly.
#[inline(always)]
fn turn(bits: u64) -> (u32, Double) {
    let (quadrant, part) = parts_of_turn(bits);
    let hi = part as f64;
    let lo = part.wrapping_sub(hi as i64) as f64;
    (
        quadrant,
        Double { hi, lo } * Double::from_f64(power_of_two(-65)),
    )
}
