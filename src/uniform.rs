//! Uniform numbers of full precision from a generator's words.
//!
//! The usual `(word >> 40) · 2⁻²⁴` has 2²⁴ values, the least above zero being 6·10⁻⁸: no tail
//! beyond it is ever sampled. Here a probability is drawn as its nearer tail p and a side.
//!
//! | type | words (bits) | p lies on the odd multiples of | p from | rounding to the format |
//! |---|---|---|---|---|
//! | `f32` | one `next_u64` (64) | 2⁻⁶⁵ | 2⁻⁶⁵ to ½ | to nearest; exact below 2⁻⁴¹ |
//! | the coarse type | one `next_u32` (31 of its 32), the upper half of 64 bits | 2⁻³² | 2⁻³² to ½ | to nearest |
//! | `f64` | two `next_u64` (128) | 2⁻¹²⁹ | 2⁻¹²⁹ to ½ | to nearest; exact below 2⁻⁷⁶ |
//!
//! Samples of [`Disk`](crate::Disk), [`Ball`](crate::Ball) and [`SphereShell`](crate::SphereShell)
//! need two uniforms, and take each from one half of those bits; for the coarse type they draw one
//! `next_u64`. A half reaches down to 2⁻³³ (`f64`: 2⁻⁶⁵; the coarse type: 2⁻³²), and both its tails
//! are rounded once.
//!
//! Neither p nor 1 − p is ever 0. Each function is a pure map of words (`…_from_bits`) or draws
//! those words, always the same number of them.

use crate::number::Real;
use crate::number::tier::{Code, Tier};
use crate::{CosSin, Tails};
use rand_core::Rng;

/// The random bits behind one [`Tails`]: `u64` for 32-bit types, `u128` for `f64`.
pub type TailBits<T> = <T as Tier>::TailBits;

/// The random bits behind one azimuth: `u32` for `f32`, `u64` for `f64`.
pub type TurnBits<T> = <T as Tier>::TurnBits;

/// A uniform probability as both its tails. The top bit chooses the nearer tail's side.
///
/// ```
/// let stuck = coslobe::uniform::tails_from_bits::<f32>(0);
/// assert_eq!(stuck.lower(), 0.5f32.powi(65)); // the deepest tail, not zero
/// ```
#[inline]
pub fn tails_from_bits<T: Real>(bits: TailBits<T>) -> Tails<T> {
    T::tails_from_bits(bits, Code::Scalar)
}

/// The tails of which the upper one is n + ½ of as many parts as there are words n; of the coarse
/// type n, made odd.
#[inline(always)]
pub(crate) fn upper_tails<T: Real>(n: TurnBits<T>, code: Code) -> Tails<T> {
    let [upper, lower] = T::tails_from_half(n, code).to_array();
    Tails::from_array([lower, upper])
}

/// (cos φ, sin φ) of a uniform azimuth: the word n stands for n + ½ parts of the whole turn.
///
/// Never on an axis. On a diagonal, where cosine and sine are equal, after rounding: 128 words of
/// `f32`, such as 0x1ffffff0, 136 of `Precise<f32>`, none of `f64`. Error of each component: 2.302
/// ulp for `f32` (exhaustive, worst word 0x150de96f), 2.222 ulp for `f64` (observed, 10⁶ words,
/// worst 0xab03af3e485dfc88).
#[inline]
pub fn azimuth_from_bits<T: Real>(bits: TurnBits<T>) -> CosSin<T> {
    T::turn_from_bits(bits)
}

/// Draws [`tails_from_bits`]: one `next_u64` for `f32`, two (high word first) for `f64`.
#[inline]
pub fn tails<T: Real, R: Rng + ?Sized>(rng: &mut R) -> Tails<T> {
    tails_from_bits::<T>(T::draw_tail_bits(rng))
}

/// Draws [`azimuth_from_bits`]: one `next_u32` for `f32`, one `next_u64` for `f64`.
#[inline]
pub fn azimuth<T: Real, R: Rng + ?Sized>(rng: &mut R) -> CosSin<T> {
    azimuth_from_bits::<T>(T::draw_turn_bits(rng))
}

/// A uniform number in (0, 1], of full relative precision towards 0; words as [`tails`].
#[inline]
pub fn unit<T: Real, R: Rng + ?Sized>(rng: &mut R) -> T {
    tails::<T, R>(rng).lower()
}
