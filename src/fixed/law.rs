//! What each law computes in words, behind [`Fixed`](super::Fixed).

use super::format::Format;
use super::q31::Q31;
use super::spatial;
use crate::CosSin;
use rand_core::Rng;

/// A probability by both tails in Q32; 1 saturates to 1 − 2⁻³².
#[derive(Clone, Copy)]
pub struct Tails {
    pub(crate) lower: u32,
    pub(crate) upper: u32,
}

impl Tails {
    #[inline(always)]
    pub(crate) fn from_lower(lower: u32) -> Self {
        let upper = (!lower).saturating_add(1);
        Tails { lower, upper }
    }

    #[inline(always)]
    pub(crate) fn swapped(self) -> Self {
        Tails {
            lower: self.upper,
            upper: self.lower,
        }
    }

    #[inline(always)]
    pub(crate) fn from_upper(upper: u32) -> Self {
        Tails::from_lower(upper).swapped()
    }

    /// Below and above the whole support.
    pub(crate) const BELOW: Tails = Tails {
        lower: 0,
        upper: u32::MAX,
    };
    pub(crate) const ABOVE: Tails = Tails {
        lower: u32::MAX,
        upper: 0,
    };
}

/// A law in integers: cosines and sines in Q31, turns in Q32, to the accuracy of F. Sealed.
pub trait Words<F: Format>: Copy {
    /// The format of its densities.
    type Density: Copy;
    /// What [`Fixed::sample`](super::Fixed::sample) returns.
    type Direction;

    fn pair(self, p: Tails) -> CosSin<i32>;
    fn tails(self, at: CosSin<i32>) -> Tails;
    fn density(self, at: CosSin<i32>) -> Self::Density;
    fn pdf(self, turn: i32) -> Self::Density;
    fn draw<R: Rng + ?Sized>(self, rng: &mut R) -> Self::Direction;

    // As in space; the laws of the plane, where θ has a sign, have their own.

    #[inline]
    fn turn(self, p: Tails) -> i32 {
        spatial::turn::<F>(self.pair(p))
    }

    #[inline]
    fn tails_at(self, turn: i32) -> Tails {
        match spatial::at_turn::<F>(turn) {
            Ok(at) => self.tails(at),
            Err(outside) => outside,
        }
    }
}

/// The laws that [`Fixed`](super::Fixed) knows. Sealed.
pub trait FixedLaw: Words<Q31> {}

impl<L: Words<Q31>> FixedLaw for L {}
