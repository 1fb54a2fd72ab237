//! `Fast<f32>` as a number type: its words, and no rounding after the formulas.

use crate::arithmetic::fast::kernel::fast;
use crate::arithmetic::fast::uniform;
use crate::arithmetic::holds::Holds;
use crate::number::Real;
use crate::number::tier::{Bits, Code, Margin, Tier};
use crate::{CosSin, Tails};
use rand_core::TryRng;

pub use crate::arithmetic::fast::Fast;

impl Holds<Fast<f32>> for Fast<f32> {
    #[inline(always)]
    fn from_number(x: Self) -> Self {
        x
    }

    #[inline(always)]
    fn from_tails(p: Tails<Self>) -> Tails<Self> {
        p
    }

    #[inline(always)]
    fn by_the_smaller(at: CosSin<Self>) -> CosSin<Self> {
        at
    }
}

impl Real for Fast<f32> {}

impl From<Fast<f32>> for f64 {
    #[inline(always)]
    fn from(x: Fast<f32>) -> f64 {
        f64::from(x.0)
    }
}

impl Tier for Fast<f32> {
    type Quick = Self;
    type Accurate = Self;
    type Base = f32;

    const UNIT_SLACK: f32 = 1.0 / 1024.0;
    type TailBits = u64;
    type TurnBits = u32;

    #[inline(always)]
    fn rounded<const N: usize>(
        _: Margin,
        quick: impl FnOnce() -> [Self; N],
        _: impl FnOnce() -> [Self; N],
    ) -> [Self; N] {
        quick()
    }

    #[inline(always)]
    fn to_base(self) -> f32 {
        self.0
    }

    #[inline(always)]
    fn from_base(x: f32) -> Self {
        Fast(x)
    }

    /// One word, the upper half; a tail reads no more.
    #[inline]
    fn try_draw_tail_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
        Ok(u64::from(rng.try_next_u32()?) << 32)
    }

    #[inline]
    fn try_draw_pair_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u64, R::Error> {
        rng.try_next_u64()
    }

    #[inline]
    fn try_draw_turn_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        rng.try_next_u32()
    }

    #[inline(always)]
    fn nearer_from_bits(bits: u64, _: Code) -> (Self, bool) {
        let (p, is_upper) = uniform::tail((bits >> 32) as u32);
        (Fast(p), is_upper)
    }

    #[inline(always)]
    fn tails_from_bits(bits: u64, code: Code) -> Tails<Self> {
        Self::tails_from_half(u64::in_order((bits >> 32) as u32), code)
    }

    #[inline(always)]
    fn tails_from_half(bits: u32, _: Code) -> Tails<Self> {
        Tails::from_array(uniform::tails(bits).map(Fast))
    }

    #[inline(always)]
    fn quick_turn_from_bits(bits: u32, code: Code) -> CosSin<Self> {
        Self::accurate_turn_from_bits(bits, code)
    }

    #[inline(always)]
    fn accurate_turn_from_bits(bits: u32, _: Code) -> CosSin<Self> {
        fast(uniform::turn(bits))
    }
}
