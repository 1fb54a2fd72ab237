//! What laws of a direction in space can do beyond [`Law`].

use super::Law;
use super::direction::Azimuth;
use crate::batch::{self, Batch, LengthError};
use crate::number::Real;
use crate::number::tier::Code;
use crate::uniform::{TailBits, TurnBits};
use crate::{CosSin, Frame, Sample, Tails};
use rand_core::{Rng, TryRng};

/// Laws of a direction in space, uniform in azimuth.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law in space, of the number type `{T}`",
    label = "not spatial",
    note = "the laws in space are Ball, SphereShell, Lambert and CosPower"
)]
pub trait Spatial<T: Real>: Law<T> {
    /// Density per steradian at polar angle θ.
    fn pdf_solid_angle(&self, theta: T) -> T;

    /// Draws \[sin θ cos φ, cos θ, sin θ sin φ\]: a unit vector with cos θ > 0.
    ///
    /// Randomness: one `next_u64` then one `next_u32` for `f32`, three `next_u64` for `f64`; no
    /// rejection.
    // Always on hosts: a loop of samples keeps the generator in registers.
    #[cfg_attr(target_pointer_width = "64", inline(always))]
    #[cfg_attr(not(target_pointer_width = "64"), inline)]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        let Ok(theta) = self.try_draw_theta(rng);
        self.sample_from_bits(theta, T::draw_turn_bits(rng))
    }

    /// [`sample`](Spatial::sample) with a generator that can fail: the same words in the same
    /// order.
    ///
    /// # Errors
    /// The generator's first error, handed on; no word is drawn after it.
    #[inline]
    fn try_sample<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<[T; 3], R::Error> {
        let theta = self.try_draw_theta(rng)?;
        Ok(self.sample_from_bits(theta, T::try_draw_turn_bits(rng)?))
    }

    /// Draws the words that [`sample_from_bits`](Spatial::sample_from_bits) makes θ of: what
    /// [`sample`](Spatial::sample) draws first.
    ///
    /// # Errors
    /// The generator's first error, handed on; no word is drawn after it.
    #[inline(always)]
    fn try_draw_theta<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<TailBits<T>, R::Error> {
        T::try_draw_tail_bits(rng)
    }

    /// The direction that [`sample`](Spatial::sample) makes of the words it draws, θ's and φ's.
    #[inline(always)]
    fn sample_from_bits(&self, theta: TailBits<T>, phi: TurnBits<T>) -> [T; 3] {
        self.drawn_direction(self.drawn_tails(theta, Code::Scalar), phi)
    }

    /// (cos θ, sin θ) of that direction.
    #[inline(always)]
    fn angle_from_bits(&self, theta: TailBits<T>) -> CosSin<T> {
        self.drawn_angle(self.drawn_tails(theta, Code::Scalar))
    }

    /// The tails that a law makes θ of when it draws.
    #[doc(hidden)]
    #[inline(always)]
    fn drawn_tails(&self, theta: TailBits<T>, code: Code) -> Tails<T> {
        T::tails_from_bits(theta, code)
    }

    /// (cos θ, sin θ) at those.
    #[doc(hidden)]
    #[inline(always)]
    fn drawn_angle(&self, p: Tails<T>) -> CosSin<T> {
        self.warp_tails(p)
    }

    /// The direction at those.
    #[doc(hidden)]
    #[inline(always)]
    fn drawn_direction(&self, p: Tails<T>, phi: TurnBits<T>) -> [T; 3] {
        self.warp_spherical(p, Azimuth::Word(phi))
    }

    /// What as many calls of [`sample`](Spatial::sample) draw, in that order: a slice for each
    /// component.
    ///
    /// # Errors
    /// If the slices have unequal lengths; then nothing is drawn or written.
    ///
    /// ```
    /// use coslobe::{Lambert, Spatial};
    /// let mut rng = rand_pcg::Pcg32::new(1, 1);
    /// let [mut x, mut y, mut z] = [[0.0f32; 100]; 3];
    /// Spatial::sample_slice(&Lambert, &mut rng, [&mut x, &mut y, &mut z])?;
    /// let mut again = rand_pcg::Pcg32::new(1, 1);
    /// assert_eq!([x[0], y[0], z[0]], Spatial::<f32>::sample(&Lambert, &mut again));
    /// # Ok::<(), coslobe::LengthError>(())
    /// ```
    fn sample_slice<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
        out: [&mut [T]; 3],
    ) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            batch::SpatialDraws(|| {
                let Ok(theta) = self.try_draw_theta(rng);
                (theta, T::draw_turn_bits(rng))
            }),
            out,
            #[inline(always)]
            |(theta, phi)| self.drawn_direction(self.drawn_tails(theta, Code::Vector), phi),
        )
    }

    /// [`sample_from_bits`](Spatial::sample_from_bits) of each pair of words.
    ///
    /// # Errors
    /// If the slices have unequal lengths; then nothing is written.
    fn sample_from_bits_slice(
        &self,
        theta: &[TailBits<T>],
        phi: &[TurnBits<T>],
        out: [&mut [T]; 3],
    ) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            (batch::Words(theta), phi),
            out,
            #[inline(always)]
            |(theta, phi)| self.drawn_direction(self.drawn_tails(theta, Code::Vector), phi),
        )
    }

    /// Draws the direction of [`sample`](Spatial::sample) with its cosine, sine and density: the
    /// same words, the same bits.
    #[inline]
    fn sample_with_density<R: Rng + ?Sized>(&self, rng: &mut R) -> Sample<T, 3> {
        let Ok(theta) = self.try_draw_theta(rng);
        // Once, so that the compiler sees that θ is the same.
        let p = self.drawn_tails(theta, Code::Scalar);
        let at = self.drawn_angle(p);
        Sample {
            direction: self.drawn_direction(p, T::draw_turn_bits(rng)),
            at,
            density: self.density(at),
        }
    }

    /// Draws a direction around the unit vector `normal`.
    ///
    /// The rotation rounds: each component, and the cosine of the direction to `normal`, is within
    /// 4 ulp of 1 of that of the direction drawn. A cosine smaller than that loses digits and
    /// may lose its sign, so that a direction beside the horizon can come out on the surface or
    /// below it. Weigh such samples by the cosine and density that
    /// [`sample_around_with_density`](Spatial::sample_around_with_density) gives. Randomness as
    /// [`sample`](Spatial::sample).
    ///
    /// ```
    /// # use coslobe::{Lambert, Spatial};
    /// # let mut rng = rand_pcg::Pcg32::new(1, 1);
    /// let d: [f32; 3] = Lambert.sample_around([0.0, 0.0, -1.0], &mut rng);
    /// assert!(d[2] < 0.0);
    /// ```
    #[inline]
    fn sample_around<R: Rng + ?Sized>(&self, normal: [T; 3], rng: &mut R) -> [T; 3] {
        Frame::from_unit(normal).to_world(Spatial::sample(self, rng))
    }

    /// Draws the direction of [`sample_around`](Spatial::sample_around) with the cosine, sine and
    /// density that it was drawn with: the same words, the same bits.
    #[inline]
    fn sample_around_with_density<R: Rng + ?Sized>(
        &self,
        normal: [T; 3],
        rng: &mut R,
    ) -> Sample<T, 3> {
        let frame = Frame::from_unit(normal);
        Spatial::sample_with_density(self, rng).rotated(|d| frame.to_world(d))
    }

    /// The direction at cdf of θ = `u[0]` and azimuth φ = `u[1]` turns: for stratified or
    /// low-discrepancy points. NaN outside \[0, 1\]². Of `Precise` each component is rounded once.
    ///
    /// A loop over an array of pairs becomes one of vectors. In a function that is generic over the
    /// law pass `[u[0], u[1]]`: a pair of `f32` that is handed on whole halves the vectors there.
    #[inline(always)]
    fn warp_direction(&self, u: [T; 2]) -> [T; 3] {
        self.warp_pair(u[0], u[1])
    }

    /// [`warp_direction`](Spatial::warp_direction) of two numbers. An array of two `f32` is passed
    /// as an integer of 64 bits, which halves a loop's vectors; what only calls this is expanded
    /// in its caller before that.
    #[doc(hidden)]
    #[inline(always)]
    fn warp_pair(&self, u: T, v: T) -> [T; 3] {
        let (u, turn) = T::probabilities(u, v);
        self.warp_spherical(Tails::at_lower(u), Azimuth::Turn(turn))
    }

    /// [`warp_direction`](Spatial::warp_direction) of each pair of `u`: a slice for each component.
    ///
    /// # Errors
    /// If the slices have unequal lengths; then nothing is written.
    fn warp_direction_slice(&self, u: [&[T]; 2], out: [&mut [T]; 3]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            (u[0], u[1]),
            out,
            #[inline(always)]
            |(u, v)| self.warp_pair(u, v),
        )
    }

    /// \[cdf of θ, azimuth in turns in \[0, 1)\] of a direction: the inverse of
    /// [`warp_direction`](Spatial::warp_direction).
    #[inline]
    fn unwarp_direction(&self, d: [T; 3]) -> [T; 2] {
        let [p, turn] = self.unwarp_spherical(d);
        // A negative turn smaller than half an ulp of 1 rounds to 1, which is 0 again.
        let turn = if turn >= T::ONE { T::ZERO } else { turn };
        [p.abs(), turn.abs()]
    }
}
