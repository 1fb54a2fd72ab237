//! What each law computes in words, behind [`Integers`](super::Integers).

use super::drawn::Drawn;
use super::format::Format;
use super::spatial;
use super::tails::Tails;
use crate::CosSin;
use ::fixed::traits::FixedUnsigned;
use ::fixed::types::U16F16;
use rand_core::TryRng;

#[diagnostic::on_unimplemented(
    message = "`{Self}` is no law in integers of this format",
    label = "not known to `Fixed` or `Fixed16`",
    note = "both know every law of this crate that has no parameter, such as `Lambert`",
    note = "with an exponent it is `coslobe::integers::CosPower` in integers, of `Fixed` alone; \
            `coslobe::CosPower` is that of floats"
)]
/// A law in integers: cosines and sines in Q31, turns in Q32, to the accuracy of F. Sealed.
pub trait Formulas<F: Format>: Copy {
    /// The format of its densities.
    type Density: FixedUnsigned;
    /// What [`Fixed::sample`](super::Integers::sample) returns.
    type Direction: Copy;

    fn warp_tails(self, p: Tails) -> CosSin<i32>;
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails;
    fn density(self, at: CosSin<i32>) -> Self::Density;
    fn pdf(self, turn: i32) -> Self::Density;
    fn lambert_weight(self, at: CosSin<i32>) -> U16F16;
    fn try_draw<R: TryRng + ?Sized>(self, rng: &mut R) -> Result<Drawn<Self::Direction>, R::Error>;

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
