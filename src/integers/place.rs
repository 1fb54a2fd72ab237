//! Directions in space of a law in integers: warped, around a normal, and back.

use super::FixedFrame;
use super::format::Format;
use super::law::Formulas;
use super::operations::{Integers, lower};
use super::spatial;
use super::tails::Tails;
use crate::{CosSin, Sample};
use rand_core::Rng;

impl<F, L> Integers<F, L>
where
    F: Format,
    L: Formulas<F, Direction = [<F as Format>::Component; 3]>,
{
    /// Density per steradian at the polar angle θ in turns.
    #[inline]
    pub fn pdf_solid_angle(&self, theta: F::Turn) -> L::Density {
        let at = spatial::at_turn::<F>(F::of_turn(theta));
        self.0.density(at.unwrap_or(CosSin { cos: -1, sin: 0 }))
    }

    /// The direction at cdf of θ = `u[0]` and azimuth φ = `u[1]` turns: for stratified or
    /// low-discrepancy points.
    #[inline]
    pub fn warp_direction(&self, u: [F::Probability; 2]) -> [F::Component; 3] {
        let at = self.0.warp_tails(lower::<F>(u[0]));
        let (x, z) = F::cos_sin(F::of_probability(u[1]));
        [F::part(at.sin, x), F::component(at.cos), F::part(at.sin, z)]
    }

    /// \[cdf of θ, azimuth in turns\] of a direction: the inverse of
    /// [`warp_direction`](Self::warp_direction). On the axis the azimuth is 0.
    #[inline]
    pub fn unwarp_direction(&self, d: [F::Component; 3]) -> [F::Probability; 2] {
        let [x, cos, z] = d.map(F::of_component);
        let (sin, turn) = spatial::polar::<F>(x, z);
        let Tails { lower, .. } = self.0.unwarp_tails(CosSin { cos, sin });
        [F::probability(lower), F::phase(turn)]
    }

    /// Draws a direction around the unit vector `normal`. Any vector is safe; how far its length
    /// may be from 1 is said, and checked, by [`FixedFrame::new`].
    ///
    /// The rotation rounds: a direction beside the horizon can come out on the surface or below it.
    /// Weigh it by the cosine and density of
    /// [`sample_around_with_density`](Self::sample_around_with_density).
    /// Randomness as [`sample`](Self::sample).
    ///
    /// ```
    /// use coslobe::{Fixed, Lambert};
    /// use fixed::types::I1F31;
    /// let mut rng = rand_pcg::Pcg32::new(1, 1);
    /// // −1 is a number, 1 is not: MAX stands for it
    /// let down = [I1F31::ZERO, I1F31::ZERO, I1F31::MIN];
    /// let d = Fixed(Lambert).sample_around(down, &mut rng);
    /// assert!(d[2] < 0);
    /// ```
    #[inline]
    pub fn sample_around<R: Rng + ?Sized>(
        &self,
        normal: [F::Component; 3],
        rng: &mut R,
    ) -> [F::Component; 3] {
        FixedFrame::from_unit(normal).to_world(self.sample(rng))
    }

    /// Draws the direction of [`sample_around`](Self::sample_around) with the cosine, sine and
    /// density that it was drawn with: the same words, the same bits.
    #[inline]
    pub fn sample_around_with_density<R: Rng + ?Sized>(
        &self,
        normal: [F::Component; 3],
        rng: &mut R,
    ) -> Sample<F::Component, 3, L::Density> {
        let frame = FixedFrame::from_unit(normal);
        self.sample_with_density(rng).rotated(|d| frame.to_world(d))
    }
}
