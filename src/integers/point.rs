//! The point before it was normalised, in integers.

use super::format::Format;
use super::law::Formulas;
use super::operations::{Integers, of_words, words};
use crate::law::Point;
use crate::{CosSin, Measure, RadiusError};
use ::fixed::traits::{Fixed, FixedSigned};
use rand_core::Rng;

/// The radius ρ of the disk or ball, in a unit of length of yours: [`Radius`](crate::Radius) in
/// integers.
///
/// `D` is any signed number of the `fixed` crate with as many bits as the law's components: 32 for
/// [`Fixed`](type@crate::Fixed), such as `I16F16` or `I32F0`; 16 for
/// [`Fixed16`](type@crate::Fixed16), such as `I8F8`. Distances and coordinates are of the same
/// type. ρ is at least one unit of it and at most a quarter of the largest number, so that nothing
/// saturates: 2ρ cos θ is half of it at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedRadius<D>(D);

impl<D: FixedSigned> FixedRadius<D> {
    /// Checks `rho`.
    ///
    /// # Errors
    /// If `rho` is not positive or above a quarter of the largest number.
    #[inline]
    pub fn new(rho: D) -> Result<Self, RadiusError> {
        if rho <= D::ZERO {
            Err(RadiusError::TooSmall)
        } else if rho > D::MAX >> 2u32 {
            Err(RadiusError::TooLarge)
        } else {
            Ok(FixedRadius(rho))
        }
    }

    /// ρ.
    #[inline]
    pub fn get(self) -> D {
        self.0
    }
}

/// A number as a component's bits, and back.
#[inline(always)]
fn word<F: Format, D: FixedSigned<Bits = Bits<F>>>(x: D) -> i32 {
    F::of_component(F::Component::from_bits(x.to_bits()))
}

#[inline(always)]
fn of_word<F: Format, D: FixedSigned<Bits = Bits<F>>>(word: i32) -> D {
    D::from_bits(F::component(word).to_bits())
}

type Bits<F> = <<F as Format>::Component as Fixed>::Bits;

/// 2ρ cos θ times `share` in Q32, 0 below the horizon; ρ a word of at most 2²⁹.
#[inline(always)]
fn along<F: Format>(rho: i32, at: CosSin<i32>, share: Option<u32>) -> i32 {
    let cos = (at.cos.max(0) as u32) << 1;
    let part = share.map_or(cos, |share| F::mul(cos, share));
    (F::mul((rho as u32) << 3, part).wrapping_add(2) >> 2) as i32
}

impl<F: Format, L: Formulas<F> + Point> Integers<F, L> {
    /// The point's measure.
    pub const MEASURE: Measure = L::MEASURE;

    /// Distance r of the point in direction `at`: 2ρ cos θ on the curve or surface, times √v in the
    /// disk, times ∛v in the ball; 0 below the horizon. As
    /// [`Tangent::distance`](crate::Tangent::distance) of floats.
    #[inline]
    pub fn distance<D: FixedSigned<Bits = Bits<F>>>(
        &self,
        rho: FixedRadius<D>,
        at: CosSin<F::Component>,
        v: F::Probability,
    ) -> D {
        let v = F::of_probability(v);
        let share = match L::MEASURE {
            Measure::Area => Some(F::saturated(F::sqrt(v)) << 1),
            Measure::Volume => Some(F::cbrt(v)),
            _ => None,
        };
        of_word::<F, D>(along::<F>(word::<F, D>(rho.get()), words::<F>(at), share))
    }

    /// Draws r for a direction.
    ///
    /// Randomness: words for the disk and ball alone, the largest of two or three uniform numbers,
    /// which needs no root: two or three words, in `Fixed16` one or two.
    #[inline]
    pub fn sample_distance<D: FixedSigned<Bits = Bits<F>>, R: Rng + ?Sized>(
        &self,
        rho: FixedRadius<D>,
        at: CosSin<F::Component>,
        rng: &mut R,
    ) -> D {
        let Ok(share) = match L::MEASURE {
            Measure::Area => F::largest::<2, R>(rng).map(Some),
            Measure::Volume => F::largest::<3, R>(rng).map(Some),
            _ => Ok(None),
        };
        of_word::<F, D>(along::<F>(word::<F, D>(rho.get()), words::<F>(at), share))
    }

    /// Draws the point itself, \[x, y\] or \[x, y, z\]: the distance times the direction.
    ///
    /// Randomness: [`sample`](Self::sample), then [`sample_distance`](Self::sample_distance).
    ///
    /// ```
    /// use coslobe::integers::FixedRadius;
    /// use coslobe::{Ball, Fixed, RadiusError};
    /// use fixed::types::I16F16;
    /// let mut rng = rand_pcg::Pcg32::new(1, 1);
    /// let radius = FixedRadius::new(I16F16::from_num(100))?; // say millimetres
    /// let [x, y, z] = Fixed(Ball).sample_point(radius, &mut rng).map(f64::from);
    /// assert!(x.hypot(y - 100.0).hypot(z) < 100.001);
    /// # Ok::<(), RadiusError>(())
    /// ```
    #[inline]
    pub fn sample_point<D: FixedSigned<Bits = Bits<F>>, R: Rng + ?Sized, const N: usize>(
        &self,
        rho: FixedRadius<D>,
        rng: &mut R,
    ) -> [D; N]
    where
        L: Formulas<F, Direction = [F::Component; N]>,
    {
        let Ok(drawn) = self.0.try_draw(rng);
        let r: D = self.sample_distance(rho, of_words::<F>(drawn.at), rng);
        let r = word::<F, D>(r);
        let component = |c| F::part(r, F::of_component(c)).to_bits();
        drawn.direction.map(|c| D::from_bits(component(c)))
    }
}
