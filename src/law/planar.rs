//! What laws of a direction in the plane can do beyond [`Law`].

use super::Law;
use crate::batch::{self, Batch, LengthError};
use crate::number::Real;
use crate::number::tier::Code;
use crate::uniform::TailBits;
use crate::{CosSin, Sample};
use rand_core::{Rng, TryRng};

/// Laws of a direction in the plane.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law in the plane, of the number type `{T}`",
    label = "not planar",
    note = "the laws in the plane are Disk, CircleShell and CircleArc"
)]
pub trait Planar<T: Real>: Law<T> {
    /// Draws \[sin θ, cos θ\]: a unit vector with cos θ > 0.
    ///
    /// Randomness: one `next_u64` for `f32`, two for `f64`; no rejection.
    // Always on hosts: a loop of samples keeps the generator in registers.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline)]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        let Ok(theta) = self.try_draw_theta(rng);
        self.sample_from_bits(theta)
    }

    /// [`sample`](Planar::sample) with a generator that can fail: the same words in the same order.
    ///
    /// # Errors
    /// The generator's first error, handed on; no word is drawn after it.
    #[inline]
    fn try_sample<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[T; 2], R::Error> {
        Ok(self.sample_from_bits(self.try_draw_theta(rng)?))
    }

    /// Draws the words that [`sample_from_bits`](Planar::sample_from_bits) makes θ of: what
    /// [`sample`](Planar::sample) draws.
    ///
    /// # Errors
    /// The generator's first error, handed on; no word is drawn after it.
    #[inline(always)]
    fn try_draw_theta<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<TailBits<T>, R::Error> {
        T::try_draw_tail_bits(rng)
    }

    /// The direction that [`sample`](Planar::sample) makes of the words it draws.
    #[inline(always)]
    fn sample_from_bits(&self, bits: TailBits<T>) -> [T; 2] {
        self.sample_by(bits, Code::Scalar)
    }

    #[doc(hidden)]
    #[inline(always)]
    fn sample_by(&self, bits: TailBits<T>, code: Code) -> [T; 2] {
        let CosSin { cos, sin } = self.warp_tails(T::tails_from_bits(bits, code));
        [sin, cos]
    }

    /// What as many calls of [`sample`](Planar::sample) draw, in that order: sines, then cosines.
    ///
    /// # Errors
    /// If the slices have unequal lengths; then nothing is drawn or written.
    fn sample_slice<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
        out: [&mut [T]; 2],
    ) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            batch::PlanarDraws(|| {
                let Ok(theta) = self.try_draw_theta(rng);
                theta
            }),
            out,
            #[inline(always)]
            |bits| self.sample_by(bits, Code::Vector),
        )
    }

    /// [`sample_from_bits`](Planar::sample_from_bits) of each word.
    ///
    /// # Errors
    /// If the slices have unequal lengths; then nothing is written.
    fn sample_from_bits_slice(
        &self,
        bits: &[TailBits<T>],
        out: [&mut [T]; 2],
    ) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            batch::Words(bits),
            out,
            #[inline(always)]
            |bits| self.sample_by(bits, Code::Vector),
        )
    }

    /// Draws the direction of [`sample`](Planar::sample) with its cosine, sine and density: the
    /// same words, the same bits.
    #[inline]
    fn sample_with_density<R: Rng + ?Sized>(&self, rng: &mut R) -> Sample<T, 2> {
        let [sin, cos] = self.sample(rng);
        let at = CosSin { cos, sin };
        Sample {
            direction: [sin, cos],
            at,
            density: self.density(at),
        }
    }
}
