//! `f64` as a number type: its formulas run in its own arithmetic, and nothing is rounded after
//! them.

use super::Real;
use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::f64::power_of_two;
use crate::arithmetic::native::turn::at_quadrant;
use crate::arithmetic::native::uniform::f64 as uniform;
use crate::number::tier::{Code, Margin, Tier};
use crate::{CosSin, Tails};
use rand_core::TryRng;

impl Real for f64 {}

impl Holds<f64> for f64 {
    #[inline(always)]
    fn from_number(x: f64) -> f64 {
        x
    }

    #[inline(always)]
    fn from_tails(p: Tails<f64>) -> Tails<f64> {
        p
    }

    #[inline(always)]
    fn by_the_smaller(at: CosSin<f64>) -> CosSin<f64> {
        at
    }
}

impl Tier for f64 {
    type Quick = f64;
    type Accurate = f64;
    type Base = f64;

    const UNIT_SLACK: f64 = power_of_two(-34);
    type TailBits = u128;
    type TurnBits = u64;

    #[inline(always)]
    fn rounded<const N: usize>(
        _: Margin,
        quick: impl FnOnce() -> [f64; N],
        _: impl FnOnce() -> [f64; N],
    ) -> [f64; N] {
        quick()
    }

    #[inline(always)]
    fn to_base(self) -> f64 {
        self
    }

    #[inline(always)]
    fn from_base(x: f64) -> f64 {
        x
    }

    #[inline]
    fn try_draw_tail_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u128, R::Error> {
        let high = u128::from(rng.try_next_u64()?);
        Ok((high << 64) | u128::from(rng.try_next_u64()?))
    }

    #[inline]
    fn try_draw_turn_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
        rng.try_next_u64()
    }

    #[inline(always)]
    fn nearer_from_bits(bits: u128, code: Code) -> (f64, bool) {
        (uniform::tail(bits << 1 >> 1, code), bits >> 127 != 0)
    }

    #[inline(always)]
    fn tails_from_half(bits: u64, _: Code) -> Tails<f64> {
        Tails::from_array(uniform::tails_of_half(bits))
    }

    #[inline(always)]
    fn quick_turn_from_bits(bits: u64, code: Code) -> CosSin<f64> {
        Self::accurate_turn_from_bits(bits, code)
    }

    #[inline(always)]
    fn accurate_turn_from_bits(bits: u64, code: Code) -> CosSin<f64> {
        let (quadrant, x) = uniform::turn(bits, code);
        at_quadrant(quadrant, x)
    }
}
