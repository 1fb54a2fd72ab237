//! A number type's accuracy tier: which arithmetic its formulas run in, and how their results are
//! rounded.

use super::kernel::Kernel;
use super::native::format::Native;
use super::scalar::Scalar;
use crate::{CosSin, Tails};
use rand_core::Rng;

/// A working arithmetic that holds every number of the type `T`.
pub trait Holds<T: Scalar>: Kernel {
    fn of(x: T) -> Self;

    /// The same probability: the nearer tail is exact, so the other is found again from it.
    #[inline(always)]
    fn of_tails(p: Tails<T>) -> Tails<Self> {
        let (p, is_lower) = p.nearer();
        Tails::from_nearer(Self::of(p), is_lower == 0)
    }

    #[inline(always)]
    fn of_pair(at: CosSin<T>) -> CosSin<Self> {
        CosSin {
            cos: Self::of(at.cos),
            sin: Self::of(at.sin),
        }
    }

    /// The direction that the smaller component names: the larger one is found again from it, since
    /// as a `T` it has been rounded.
    #[inline(always)]
    fn of_direction(at: CosSin<T>) -> CosSin<Self> {
        let CosSin { cos, sin } = Self::of_pair(at);
        let other = |x: Self, rounded: Self| {
            if rounded.is_nan() {
                rounded
            } else {
                (Self::ONE - x * x).sqrt().copysign(rounded)
            }
        };
        if sin.abs() < cos.abs() {
            CosSin {
                cos: other(sin, cos),
                sin,
            }
        } else {
            CosSin {
                cos,
                sin: other(cos, sin),
            }
        }
    }
}

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
    type Work: Holds<Self>;
    /// The format that exact constants are read from.
    type Base: Native;

    /// How far the square of a unit vector's length may be from 1.
    const UNIT_SLACK: Self::Base;

    /// The results of `fine`, rounded; those of `quick` where they can be seen to round alike.
    fn rounded<const N: usize>(
        margin: Margin,
        quick: impl FnOnce() -> [Self::Quick; N],
        fine: impl FnOnce() -> [Self::Work; N],
    ) -> [Self; N];

    fn to_base(self) -> Self::Base;
    fn of_base(x: Self::Base) -> Self;

    /// Random bits behind one [`Tails`].
    type TailBits: Copy;
    /// Random bits behind one azimuth.
    type TurnBits: Copy;
    fn draw_tail_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TailBits;
    fn draw_turn_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TurnBits;
    fn tails_of(bits: Self::TailBits) -> Tails<Self>;
    fn turn_of(bits: Self::TurnBits) -> CosSin<Self>;
}
