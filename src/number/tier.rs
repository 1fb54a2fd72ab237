//! A number type's accuracy tier: which arithmetics its formulas run in, and how their results are
//! rounded.

use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::format::Native;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};
use rand_core::Rng;

/// What a rounding test may take as the error of a quick result.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Margin {
    /// In proportion to the result.
    Relative,
    /// In proportion to the larger of the result and 1.
    OfOne,
}

/// A number type of the public interface.
pub trait Tier: Scalar {
    /// The arithmetic that is tried first.
    type Quick: Holds<Self>;
    /// The arithmetic that decides.
    type Accurate: Holds<Self>;
    /// The format that exact constants are read from.
    type Base: Native;

    /// How far the square of a unit vector's length may be from 1.
    const UNIT_SLACK: Self::Base;

    /// The results of `accurate`, rounded; those of `quick` where they can be seen to round alike.
    fn rounded<const N: usize>(
        margin: Margin,
        quick: impl FnOnce() -> [Self::Quick; N],
        accurate: impl FnOnce() -> [Self::Accurate; N],
    ) -> [Self; N];

    fn to_base(self) -> Self::Base;
    fn from_base(x: Self::Base) -> Self;

    /// Random bits behind one [`Tails`].
    type TailBits: Copy;
    /// Random bits behind one azimuth.
    type TurnBits: Copy;
    fn draw_tail_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TailBits;
    fn draw_turn_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TurnBits;
    fn tails_from_bits(bits: Self::TailBits) -> Tails<Self>;
    fn turn_from_bits(bits: Self::TurnBits) -> CosSin<Self>;
}
