//! `Precise<f64>`: double-double throughout.

use super::Precise;
use crate::kernel::double::Double;
use crate::kernel::pair::Pair;
use crate::number::Real;
use crate::number::f64::{parts_of_turn, power_of_two};
use crate::number::kernel::Kernel;
use crate::number::tier::{Holds, Margin, Tier};
use crate::{CosSin, Tails};
use rand_core::Rng;

impl Holds<Precise<f64>> for Double {
    #[inline(always)]
    fn of(x: Precise<f64>) -> Double {
        Pair::exact(x.0)
    }
}

impl Real for Precise<f64> {}

impl Tier for Precise<f64> {
    type Quick = Double;
    type Work = Double;
    type Base = f64;
    type TailBits = u128;
    type TurnBits = u64;

    #[inline]
    fn rounded<const N: usize>(
        _: Margin,
        _: impl FnOnce() -> [Double; N],
        fine: impl FnOnce() -> [Double; N],
    ) -> [Self; N] {
        fine().map(|x| Precise(if x.hi.is_finite() { x.hi + x.lo } else { x.hi }))
    }

    #[inline]
    fn to_base(self) -> f64 {
        self.0
    }

    #[inline]
    fn of_base(x: f64) -> Self {
        Precise(x)
    }

    #[inline]
    fn draw_tail_bits<R: Rng + ?Sized>(rng: &mut R) -> u128 {
        f64::draw_tail_bits(rng)
    }

    #[inline]
    fn draw_turn_bits<R: Rng + ?Sized>(rng: &mut R) -> u64 {
        f64::draw_turn_bits(rng)
    }

    #[inline]
    fn tails_of(bits: u128) -> Tails<Self> {
        Tails::of_array(f64::tails_of(bits).to_array().map(Precise))
    }

    #[inline]
    fn turn_of(bits: u64) -> CosSin<Self> {
        let (quadrant, part) = parts_of_turn(bits);
        let hi = part as f64;
        let lo = (part - hi as i64) as f64;
        let x = Pair { hi, lo } * Pair::exact(power_of_two(-65));
        CosSin::of_array(Self::rounded(
            Margin::Relative,
            || Double::at_quadrant(quadrant, x).to_array(),
            || Double::at_quadrant(quadrant, x).to_array(),
        ))
    }
}
