//! What a word format gives the laws, so that each law is written once.

use ::fixed::traits::{FixedSigned, FixedUnsigned};
use rand_core::Rng;

/// A format of the results and the kernels that are accurate to it. Sealed.
///
/// Inside, all formats share one scale, words of 32 bits: components in Q31, where 2³¹ is 1, all
/// else in Q32.
pub trait Format: Copy {
    /// What the constructor is called.
    const NAME: &str;

    /// A cosine, a sine, a component of a direction.
    type Component: FixedSigned;
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

    /// A direction in space with cos θ the largest of N uniform numbers.
    fn lobe<const N: usize, R: Rng + ?Sized>(rng: &mut R) -> [Self::Component; 3];
    /// The largest of three uniform numbers, and a word whose top bit is a sign.
    fn largest_of_three<R: Rng + ?Sized>(rng: &mut R) -> (u32, u32);
    /// A direction in the plane with |sin θ| uniform.
    fn chord<R: Rng + ?Sized>(rng: &mut R) -> [Self::Component; 2];
}

/// An angle in turns, which names its format. Sealed.
pub trait Turn: Copy {
    /// The format whose angles these are.
    type Format: Format<Turn = Self>;
}
