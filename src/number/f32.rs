//! `f32` as a number type: its formulas run in its own arithmetic, and nothing is rounded after
//! them.

use super::Real;
use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::f32::power_of_two;
use crate::arithmetic::native::turn::at_quadrant;
use crate::arithmetic::native::uniform::f32 as uniform;
use crate::number::tier::{Code, Margin, Tier};
use crate::{CosSin, Tails};
use rand_core::TryRng;

impl Real for f32 {}

impl Holds<f32> for f32 {
    #[inline(always)]
    fn from_number(x: f32) -> f32 {
        x
    }

    #[inline(always)]
    fn from_tails(p: Tails<f32>) -> Tails<f32> {
        p
    }

    #[inline(always)]
    fn by_the_smaller(at: CosSin<f32>) -> CosSin<f32> {
        at
    }
}

impl Tier for f32 {
    type Quick = f32;
    type Accurate = f32;
    type Base = f32;

    const UNIT_SLACK: f32 = power_of_two(-18);
    type TailBits = u64;
    type TurnBits = u32;

    #[inline(always)]
    fn rounded<const N: usize>(
        _: Margin,
        quick: impl FnOnce() -> [f32; N],
        _: impl FnOnce() -> [f32; N],
    ) -> [f32; N] {
        quick()
    }

    #[inline(always)]
    fn to_base(self) -> f32 {
        self
    }

    #[inline(always)]
    fn from_base(x: f32) -> f32 {
        x
    }

    #[inline]
    fn try_draw_tail_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
        rng.try_next_u64()
    }

    #[inline]
    fn try_draw_turn_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        rng.try_next_u32()
    }

    #[inline(always)]
    fn nearer_from_bits(bits: u64, code: Code) -> (f32, bool) {
        (uniform::tail(bits << 1 >> 1, code), bits >> 63 != 0)
    }

    #[inline(always)]
    fn tails_from_half(bits: u32, code: Code) -> Tails<f32> {
        Tails::from_array(uniform::tails_of_half(bits, code))
    }

    #[inline(always)]
    fn quick_turn_from_bits(bits: u32, code: Code) -> CosSin<f32> {
        Self::accurate_turn_from_bits(bits, code)
    }

    #[inline(always)]
    fn accurate_turn_from_bits(bits: u32, _: Code) -> CosSin<f32> {
        let (quadrant, x) = uniform::turn(bits);
        at_quadrant(quadrant, x)
    }
}
