//! What each law computes in words, behind [`Integers`](super::Integers).

use super::format::Format;
use super::spatial;
use super::tails::Tails;
use crate::CosSin;
use ::fixed::traits::FixedUnsigned;
use rand_core::Rng;

/// A law in integers: cosines and sines in Q31, turns in Q32, to the accuracy of F. Sealed.
pub trait Formulas<F: Format>: Copy {
    /// The format of its densities.
    type Density: FixedUnsigned;
    /// What [`Fixed::sample`](super::Integers::sample) returns.
    type Direction;

    fn warp_tails(self, p: Tails) -> CosSin<i32>;
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails;
    fn density(self, at: CosSin<i32>) -> Self::Density;
    fn pdf(self, turn: i32) -> Self::Density;
    fn sample<R: Rng + ?Sized>(self, rng: &mut R) -> Self::Direction;

    // As in space; the laws of the plane, where θ has a sign, have their own.

    #[inline]
    fn quantile_tails(self, p: Tails) -> i32 {
        spatial::turn::<F>(self.warp_tails(p))
    }

    #[inline]
    fn tails(self, turn: i32) -> Tails {
        match spatial::at_turn::<F>(turn) {
            Ok(at) => self.unwarp_tails(at),
            Err(outside) => outside,
        }
    }
}
