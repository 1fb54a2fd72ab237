//! The point before it was normalised.

use crate::arithmetic::holds::Holds;
use crate::law::Point;
use crate::number::Real;
use crate::number::tier::{Code, Margin};
use crate::{CosSin, Law, Measure, Planar, Spatial, uniform};
use core::fmt;
use rand_core::Rng;

/// The radius ρ of the disk or ball: a number from the smallest normal one to a quarter of the
/// largest, so that no coordinate of a point overflows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Radius<T>(T);

/// Why a radius was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RadiusError {
    /// The radius is NaN.
    NotANumber,
    /// The radius is negative, zero or below the smallest normal number.
    TooSmall,
    /// The radius is above a quarter of the largest number.
    TooLarge,
}

impl fmt::Display for RadiusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RadiusError::NotANumber => "the radius is NaN; expected a positive number",
            RadiusError::TooSmall => "the radius is below the smallest positive normal number",
            RadiusError::TooLarge => "the radius is above a quarter of the largest finite number",
        })
    }
}

impl core::error::Error for RadiusError {}

impl<T: Real> Radius<T> {
    /// Checks `rho`.
    ///
    /// # Errors
    /// If `rho` is NaN, below the smallest normal number or above a quarter of the largest.
    pub fn new(rho: T) -> Result<Self, RadiusError> {
        if rho.is_nan() {
            Err(RadiusError::NotANumber)
        } else if rho < T::MIN_NORMAL {
            Err(RadiusError::TooSmall)
        } else if rho > T::MAX * T::QUARTER {
            Err(RadiusError::TooLarge)
        } else {
            Ok(Radius(rho))
        }
    }

    /// ρ.
    #[inline]
    pub fn get(self) -> T {
        self.0
    }
}

/// Laws whose direction comes from a point of the tangent disk, circle, ball or sphere.
///
/// The point lies at distance r from the origin: r = 2ρ cos θ on the curve or surface,
/// 2ρ cos θ · v^(1/2) in the disk, 2ρ cos θ · v^(1/3) in the ball, v uniform.
pub trait Tangent<T: Real>: Law<T> {
    /// The point's measure.
    const MEASURE: Measure;

    /// Distance r of the point in direction `at`, for a uniform v in \[0, 1\] that only
    /// [`Measure::Area`] and [`Measure::Volume`] read.
    ///
    /// No product on the way is smaller than r, so that only an r below the smallest number
    /// becomes 0. Error < 4 ulp; of `Precise` at most 0.55.
    fn distance(&self, rho: Radius<T>, at: CosSin<T>, v: T) -> T;

    /// Joint density of the point at distance `r` in direction `at`, per unit of
    /// [`MEASURE`](Tangent::MEASURE).
    ///
    /// 1/(πρ²) and 3/(4πρ³) inside the disk and ball, 0 for r > 2ρ cos θ; 1/(2πρ) and 1/(4πρ²) on
    /// the circle and sphere. For the shells the coefficient of δ(r − 2ρ cos θ) per dr dθ (dφ),
    /// which is the law's pdf. On curves, surfaces and shells `r` is not read. Overflows or
    /// underflows only where the value itself does: see
    /// [`ln_point_density`](Tangent::ln_point_density). Error < 4 ulp; of `Precise` at most 0.55.
    fn point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T;

    /// Natural logarithm of [`point_density`](Tangent::point_density), finite for every radius,
    /// even where the density underflows.
    /// Error < 4 ulp of its largest term; of `Precise` at most 0.55.
    fn ln_point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T;

    /// Draws r for a direction; only disk and ball draw a word for it, as [`uniform::unit`].
    fn sample_distance<R: Rng + ?Sized>(&self, rho: Radius<T>, at: CosSin<T>, rng: &mut R) -> T;
}

impl<T: Real, L: Point + Law<T>> Tangent<T> for L {
    const MEASURE: Measure = L::MEASURE;

    #[inline]
    fn distance(&self, rho: Radius<T>, at: CosSin<T>, v: T) -> T {
        let [r] = T::rounded(
            Margin::Relative,
            || [distance::<T, T::Quick, L>(rho, at, v)],
            || [distance::<T, T::Accurate, L>(rho, at, v)],
        );
        r
    }

    #[inline]
    fn point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T {
        let [value] = T::rounded(
            Margin::Relative,
            || {
                [L::point_density::<T::Quick>(
                    Holds::from_number(rho.get()),
                    Holds::from_components(at),
                )]
            },
            || {
                [L::point_density::<T::Accurate>(
                    Holds::from_number(rho.get()),
                    Holds::from_components(at),
                )]
            },
        );
        // + 0 turns the −0 of a cosine −0 into +0.
        on_ray::<T, L>(rho, at, r, value, T::ZERO) + T::ZERO
    }

    #[inline]
    fn ln_point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T {
        let [value] = T::rounded(
            Margin::OfOne,
            || {
                [L::ln_point_density::<T::Quick>(
                    Holds::from_number(rho.get()),
                    Holds::from_components(at),
                )]
            },
            || {
                [L::ln_point_density::<T::Accurate>(
                    Holds::from_number(rho.get()),
                    Holds::from_components(at),
                )]
            },
        );
        on_ray::<T, L>(rho, at, r, value, -T::INFINITY)
    }

    #[inline]
    fn sample_distance<R: Rng + ?Sized>(&self, rho: Radius<T>, at: CosSin<T>, rng: &mut R) -> T {
        let v = if L::IS_SOLID {
            uniform::unit(rng)
        } else {
            T::ONE
        };
        self.distance(rho, at, v)
    }
}

/// 2ρ cos θ, or a root of v of it: the product of the large factors first.
#[inline]
fn distance<T: Real, W: Holds<T>, L: Point>(rho: Radius<T>, at: CosSin<T>, v: T) -> W {
    let rho = W::from_number(rho.get());
    (rho + rho) * W::from_number(at.cos) * L::share(W::from_number(v))
}

/// `value` where the ray has a point at `r` (or `r` is not read), `outside` elsewhere.
#[inline]
fn on_ray<T: Real, L: Point>(rho: Radius<T>, at: CosSin<T>, r: T, value: T, outside: T) -> T {
    let is_ray = at.cos >= T::ZERO && (L::IS_PLANAR || at.sin >= T::ZERO);
    let reached = !L::IS_SOLID || (r >= T::ZERO && r <= (rho.get() + rho.get()) * at.cos);
    if r.is_nan() || at.cos.is_nan() || at.sin.is_nan() {
        T::NAN
    } else if is_ray && reached {
        value
    } else {
        outside
    }
}

/// Points in the plane.
pub trait PlanarPoint<T: Real>: Planar<T> + Tangent<T> {
    /// Draws the point \[x, y\] itself: the distance times the direction, each component rounded
    /// once more (of `Precise` four roundings, together within 3 ulp). Randomness:
    /// [`Planar::sample`], then [`uniform::unit`] for [`Disk`](crate::Disk) alone.
    #[inline]
    fn sample_point<R: Rng + ?Sized>(&self, rho: Radius<T>, rng: &mut R) -> [T; 2] {
        let [sin, cos] = Planar::sample(self, rng);
        let r = self.sample_distance(rho, CosSin { cos, sin }, rng);
        [r * sin, r * cos]
    }
}

impl<T: Real, L: Planar<T> + Tangent<T>> PlanarPoint<T> for L {}

/// Points in space.
pub trait SpatialPoint<T: Real>: Spatial<T> + Tangent<T> {
    /// Draws the point \[x, y, z\] itself: the distance times the direction, each component rounded
    /// once more (of `Precise` four roundings, together within 3 ulp). Randomness:
    /// [`Spatial::sample`], then [`uniform::unit`] for [`Ball`](crate::Ball) alone.
    #[inline]
    fn sample_point<R: Rng + ?Sized>(&self, rho: Radius<T>, rng: &mut R) -> [T; 3] {
        let Ok(theta) = self.try_draw_theta(rng);
        let phi = T::draw_turn_bits(rng);
        let p = self.drawn_tails(theta, Code::Scalar);
        let r = self.sample_distance(rho, self.drawn_angle(p), rng);
        self.drawn_direction(p, phi).map(|c| r * c)
    }
}

impl<T: Real, L: Spatial<T> + Tangent<T>> SpatialPoint<T> for L {}
