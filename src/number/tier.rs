//! A number type's accuracy tier: which arithmetics its formulas run in, and how their results are
//! rounded.

use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::format::Native;
pub(crate) use crate::arithmetic::native::uniform::Code;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};
use rand_core::{Rng, TryRng};

/// What bounds the error of a quick result in the rounding test.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Margin {
    /// In proportion to the result.
    Relative,
    /// In proportion to the larger of the result and 1.
    OfOne,
    /// Nothing, where `f64` is the quick phase.
    Unbounded,
}

/// Random bits, and their halves: a loop over halves is as wide as one over the numbers made of
/// them.
pub trait Bits: Copy + Default {
    type Half: Copy + Default + Ord;
    /// The upper half, then the lower. No array: one of two words is handed on as one number,
    /// which a compiler turns around and takes apart.
    fn split(self) -> (Self::Half, Self::Half);
    fn join(upper: Self::Half, lower: Self::Half) -> Self;
    /// The square of a half, cut off to its upper half.
    fn square(half: Self::Half) -> Self::Half;
    /// The count of a lower tail whose word's top bit is the side of the nearer one, from which the
    /// others count.
    fn in_order(half: Self::Half) -> Self::Half;
}

impl Bits for u64 {
    type Half = u32;
    #[inline(always)]
    fn split(self) -> (u32, u32) {
        ((self >> 32) as u32, self as u32)
    }
    #[inline(always)]
    fn join(upper: u32, lower: u32) -> u64 {
        u64::from(upper) << 32 | u64::from(lower)
    }
    #[inline(always)]
    fn square(half: u32) -> u32 {
        ((u64::from(half) * u64::from(half)) >> 32) as u32
    }
    #[inline(always)]
    fn in_order(half: u32) -> u32 {
        half ^ ((half as i32 >> 31) as u32 >> 1)
    }
}

impl Bits for u128 {
    type Half = u64;
    #[inline(always)]
    fn split(self) -> (u64, u64) {
        ((self >> 64) as u64, self as u64)
    }
    #[inline(always)]
    fn join(upper: u64, lower: u64) -> u128 {
        u128::from(upper) << 64 | u128::from(lower)
    }
    #[inline(always)]
    fn square(half: u64) -> u64 {
        ((u128::from(half) * u128::from(half)) >> 64) as u64
    }
    #[inline(always)]
    fn in_order(half: u64) -> u64 {
        half ^ ((half as i64 >> 63) as u64 >> 1)
    }
}

/// A number type of the public interface.
pub trait Tier: Scalar {
    /// The arithmetic of the quick phase, which is tried first.
    type Quick: Holds<Self>;
    /// The arithmetic of the accurate phase, which decides where the quick one cannot.
    type Accurate: Holds<Self>;
    /// The format that exact constants are read from.
    type Base: Native;

    /// How far the square of a unit vector's length may be from 1.
    const UNIT_SLACK: Self::Base;

    /// The results of the accurate phase, rounded; those of the quick phase where a rounding test
    /// shows that they round to the same numbers.
    fn rounded<const N: usize>(
        margin: Margin,
        quick: impl FnOnce() -> [Self::Quick; N],
        accurate: impl FnOnce() -> [Self::Accurate; N],
    ) -> [Self; N];

    fn to_base(self) -> Self::Base;
    fn from_base(x: Self::Base) -> Self;

    /// Random bits behind one [`Tails`], or behind two uniforms, each of half the bits:
    /// probabilities or azimuths.
    type TailBits: Bits<Half = Self::TurnBits>;
    /// Random bits behind one azimuth.
    type TurnBits: Copy + Default + Ord;
    fn try_draw_tail_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self::TailBits, R::Error>;
    /// Those of two uniforms: more words where a tail does not read all the bits.
    #[inline(always)]
    fn try_draw_pair_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self::TailBits, R::Error> {
        Self::try_draw_tail_bits(rng)
    }
    fn try_draw_turn_bits<R: TryRng + ?Sized>(rng: &mut R) -> Result<Self::TurnBits, R::Error>;
    #[inline(always)]
    fn draw_tail_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TailBits {
        let Ok(bits) = Self::try_draw_tail_bits(rng);
        bits
    }
    #[inline(always)]
    fn draw_turn_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TurnBits {
        let Ok(bits) = Self::try_draw_turn_bits(rng);
        bits
    }
    /// The nearer tail, and whether it is the upper one.
    fn nearer_from_bits(bits: Self::TailBits, code: Code) -> (Self, bool);

    #[inline(always)]
    fn tails_from_bits(bits: Self::TailBits, code: Code) -> Tails<Self> {
        let (p, is_upper) = Self::nearer_from_bits(bits, code);
        Tails::from_side(p, is_upper)
    }
    /// A probability of half the bits: the lower tail is n and a half of as many parts as there are
    /// words n.
    fn tails_from_half(n: Self::TurnBits, code: Code) -> Tails<Self>;
    /// (cos φ, sin φ) of an azimuth in either arithmetic.
    fn quick_turn_from_bits(bits: Self::TurnBits, code: Code) -> CosSin<Self::Quick>;
    fn accurate_turn_from_bits(bits: Self::TurnBits, code: Code) -> CosSin<Self::Accurate>;

    #[inline(always)]
    fn turn_from_bits(bits: Self::TurnBits) -> CosSin<Self> {
        CosSin::from_array(Self::rounded(
            Margin::Relative,
            #[inline(always)]
            || Self::quick_turn_from_bits(bits, Code::Scalar).to_array(),
            #[inline(always)]
            || Self::accurate_turn_from_bits(bits, Code::Scalar).to_array(),
        ))
    }
}
