//! What a word format gives the laws, so that each law is written once.

use super::drawn::Drawn;
use ::fixed::traits::{FixedSigned, FixedUnsigned};
use rand_core::TryRng;

/// A format of the results and the kernels that are accurate to it. Sealed.
///
/// Inside, all formats share one scale, words of 32 bits: components in Q31, where 2³¹ is 1, all
/// else in Q32.
pub trait Format: Copy {
    /// What the constructor is called.
    const NAME: &str;

    /// A cosine, a sine, a component of a direction.
    type Component: Component<Format = Self>;
    /// A probability; the density of a law without an exponent.
    type Probability: FixedUnsigned;
    /// An angle in turns.
    type Turn: Turn<Format = Self>;

    /// The smallest word that is not 0 as a result, for a component and for a probability.
    const LEAST: u32;

    fn component(q31: i32) -> Self::Component;
    fn of_component(component: Self::Component) -> i32;
    fn probability(q32: u32) -> Self::Probability;
    fn of_probability(probability: Self::Probability) -> u32;
    fn turn(q32: i32) -> Self::Turn;
    /// An azimuth in turns, which wraps where [`probability`](Format::probability) saturates.
    fn phase(q32: u32) -> Self::Probability;
    fn of_turn(turn: Self::Turn) -> i32;

    /// A magnitude whose component is at most 1 less one unit.
    fn saturated(magnitude: u32) -> u32;
    /// A component of [`cos_sin`](Format::cos_sin) such that ±1 saturates when it is rounded.
    fn clamped(q31: i32) -> i32;
    /// A component inside the open support: at least one unit, at most 1 less one.
    #[inline(always)]
    fn inside(magnitude: u32) -> u32 {
        Self::saturated(magnitude.max(Self::LEAST))
    }
    /// A saturated magnitude with the sign of `sign`'s top bit.
    fn signed(magnitude: u32, sign: u32) -> i32;
    fn mul(a: u32, b: u32) -> u32;
    /// x times a constant, whose rounding costs nothing.
    fn times(x: u32, constant: u32) -> u32;
    /// √x in Q31, of a probability.
    fn sqrt(x: u32) -> u32;
    /// √(x·2⁻ᵉ) in Q32, of x ≥ ⅛.
    fn scaled(x: u32, e: u32) -> u32;
    /// ⁴√x in Q31 and √x in Q32, of a probability.
    fn fourth(x: u32) -> (u32, u32);
    /// ∛x in Q32, of a probability.
    fn cbrt(x: u32) -> u32;
    /// 1/(2d) of d ≥ ½.
    fn half_recip(d: u32) -> u32;
    /// √(v (2 − v)) in Q31.
    fn complement(v: u32) -> u32;
    /// Quarter turns from the nearer end at ∛p, for the disk.
    fn from_end(z: u32) -> u32;
    /// (cos, sin) of x quarter turns.
    fn quarter(x: u32) -> (u32, u32);
    /// (cos, sin) of an angle in turns.
    fn cos_sin(turn: u32) -> (i32, i32);
    /// The angle in turns of two magnitudes.
    fn first_quadrant(cos: u32, sin: u32) -> u32;

    /// How far length² may be from 1 in Q62, for a sample.
    const LENGTH_SLACK: u64;
    /// How far length² may be from 1 in Q30, for a normal.
    const SLACK: u32;
    /// A component in the units of its own format, −1 as one unit more.
    fn units(component: Self::Component) -> i32;
    fn of_units(units: i32) -> Self::Component;
    /// |length² − 1| in Q30, of components in units.
    fn square_off(normal: [i32; 3]) -> u32;
    /// 1/(1 + |z|), for the two that follow.
    fn frame_recip(z: i32) -> i32;
    fn to_world(normal: [i32; 3], recip: i32, local: [i32; 3]) -> [i32; 3];
    fn to_local(normal: [i32; 3], recip: i32, world: [i32; 3]) -> [i32; 3];
    /// The product of a component's word, not negative, and a part of it.
    fn part(sin: i32, part: i32) -> Self::Component;

    /// A direction in space with cos θ the largest of N uniform numbers.
    fn lobe<const N: usize, R: TryRng + ?Sized>(
        rng: &mut R,
    ) -> Result<Drawn<[Self::Component; 3]>, R::Error>;
    /// The largest of N = 2, 3 or 4 uniform numbers, in Q32.
    fn largest<const N: usize, R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error>;
    /// The largest of three uniform numbers, and a word whose top bit is a sign.
    fn largest_of_three<R: TryRng + ?Sized>(rng: &mut R) -> Result<(u32, u32), R::Error>;
    /// A direction in the plane with |sin θ| uniform.
    fn chord<R: TryRng + ?Sized>(rng: &mut R) -> Result<Drawn<[Self::Component; 2]>, R::Error>;
}

/// An angle in turns, which names its format. Sealed.
pub trait Turn: Copy {
    /// The format whose angles these are.
    type Format: Format<Turn = Self>;
}

/// A component of a direction, which names its format. Sealed.
pub trait Component: FixedSigned {
    /// The format whose components these are.
    type Format: Format<Component = Self>;
}
