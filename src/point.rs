//! The point before it was normalised.

use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::number::Real;
use crate::number::tier::Margin;
use crate::{CosSin, Law, Planar, Spatial, uniform};
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

/// By which measure the point is uniform, and so what its density is per.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Measure {
    /// Area of the disk.
    Area,
    /// Arc length of the circle.
    ArcLength,
    /// Radial shell on the circle: dr dθ.
    CircleShell,
    /// Volume of the ball.
    Volume,
    /// Area of the sphere.
    SurfaceArea,
    /// Radial shell on the sphere: dr dθ dφ.
    SphereShell,
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
    /// No product on the way is smaller than r, so that only an r below the smallest number becomes 0.
    /// Error < 4 ulp; of `Precise` at most 0.55.
    #[inline]
    fn distance(&self, rho: Radius<T>, at: CosSin<T>, v: T) -> T {
        let (rho, cos) = (rho.get(), at.cos);
        let [r] = T::rounded(
            Margin::Relative,
            || {
                [distance::<T::Quick>(
                    Self::MEASURE,
                    Holds::from_number(rho),
                    Holds::from_number(cos),
                    Holds::from_number(v),
                )]
            },
            || {
                [distance::<T::Accurate>(
                    Self::MEASURE,
                    Holds::from_number(rho),
                    Holds::from_number(cos),
                    Holds::from_number(v),
                )]
            },
        );
        r
    }

    /// Joint density of the point at distance `r` in direction `at`, per unit of
    /// [`MEASURE`](Tangent::MEASURE).
    ///
    /// 1/(πρ²) and 3/(4πρ³) inside the disk and ball, 0 for r > 2ρ cos θ; 1/(2πρ) and 1/(4πρ²) on
    /// the circle and sphere. For the shells the coefficient of δ(r − 2ρ cos θ) per dr dθ (dφ),
    /// which is the law's pdf. On curves, surfaces and shells `r` is not read. Overflows or
    /// underflows only where the value itself does: see
    /// [`ln_point_density`](Tangent::ln_point_density). Error < 4 ulp; of `Precise` at most 0.55.
    #[inline]
    fn point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T {
        let radius = rho.get();
        let [value] = T::rounded(
            Margin::Relative,
            || {
                [density::<T::Quick>(
                    Self::MEASURE,
                    Holds::from_number(radius),
                    Holds::from_components(at),
                )]
            },
            || {
                [density::<T::Accurate>(
                    Self::MEASURE,
                    Holds::from_number(radius),
                    Holds::from_components(at),
                )]
            },
        );
        // + 0 turns the −0 of a cosine −0 into +0.
        inside(Self::MEASURE, rho, at, r, value, T::ZERO) + T::ZERO
    }

    /// Natural logarithm of [`point_density`](Tangent::point_density), finite for every radius, and
    /// where the density underflows.
    /// Error < 4 ulp of its largest term; of `Precise` at most 0.55.
    #[inline]
    fn ln_point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T {
        let radius = rho.get();
        let [value] = T::rounded(
            Margin::OfOne,
            || {
                [ln_density::<T::Quick>(
                    Self::MEASURE,
                    Holds::from_number(radius),
                    Holds::from_components(at),
                )]
            },
            || {
                [ln_density::<T::Accurate>(
                    Self::MEASURE,
                    Holds::from_number(radius),
                    Holds::from_components(at),
                )]
            },
        );
        inside(Self::MEASURE, rho, at, r, value, -T::INFINITY)
    }

    /// Draws r for a direction; only disk and ball draw a word for it, as [`uniform::unit`].
    #[inline]
    fn sample_distance<R: Rng + ?Sized>(&self, rho: Radius<T>, at: CosSin<T>, rng: &mut R) -> T {
        let v = match Self::MEASURE {
            Measure::Area | Measure::Volume => uniform::unit(rng),
            _ => T::ONE,
        };
        self.distance(rho, at, v)
    }
}

/// 2ρ cos θ, or a root of v of it: the product of the large factors first.
#[inline]
fn distance<W: Kernel>(measure: Measure, rho: W, cos: W, v: W) -> W {
    let share = match measure {
        Measure::Area => v.sqrt(),
        Measure::Volume => v.cbrt(),
        _ => W::ONE,
    };
    (rho + rho) * cos * share
}

#[inline]
fn density<W: Kernel>(measure: Measure, rho: W, at: CosSin<W>) -> W {
    let (recip_rho, recip_pi) = (W::ONE / rho, W::CONSTANTS.recip_pi.value());
    let three_over_two_pi = W::CONSTANTS.three_over_two_pi.value();
    match measure {
        Measure::Area => recip_pi / rho * recip_rho,
        Measure::ArcLength => recip_pi * W::HALF / rho,
        Measure::CircleShell => at.cos * W::HALF,
        Measure::Volume => three_over_two_pi * W::HALF / rho * recip_rho * recip_rho,
        Measure::SurfaceArea => recip_pi * W::QUARTER / rho * recip_rho,
        Measure::SphereShell => at.cos * at.cos * three_over_two_pi * at.sin,
    }
}

#[inline]
fn ln_density<W: Kernel>(measure: Measure, rho: W, at: CosSin<W>) -> W {
    let ln_rho = rho.ln();
    let (ln_pi, ln_2) = (W::CONSTANTS.ln_pi.value(), W::CONSTANTS.ln_2.value());
    let ln_three_over_two_pi = W::CONSTANTS.ln_three_over_two_pi.value();
    match measure {
        Measure::Area => -(ln_pi + ln_rho * W::int(2)),
        Measure::ArcLength => -(W::CONSTANTS.ln_two_pi.value() + ln_rho),
        Measure::CircleShell => at.cos.ln() - ln_2,
        Measure::Volume => ln_three_over_two_pi - (ln_2 + ln_rho * W::int(3)),
        Measure::SurfaceArea => -(ln_pi + (ln_2 + ln_rho) * W::int(2)),
        Measure::SphereShell => ln_three_over_two_pi + at.cos.ln() * W::int(2) + at.sin.ln(),
    }
}

/// `value` where the ray has a point at `r` (or `r` is not read), `outside` elsewhere.
#[inline]
fn inside<T: Real>(
    measure: Measure,
    rho: Radius<T>,
    at: CosSin<T>,
    r: T,
    value: T,
    outside: T,
) -> T {
    let (solid, planar) = match measure {
        Measure::Area => (true, true),
        Measure::ArcLength | Measure::CircleShell => (false, true),
        Measure::Volume => (true, false),
        Measure::SurfaceArea | Measure::SphereShell => (false, false),
    };
    let on_ray = at.cos >= T::ZERO && (planar || at.sin >= T::ZERO);
    let reached = !solid || (r >= T::ZERO && r <= (rho.get() + rho.get()) * at.cos);
    if r.is_nan() || at.cos.is_nan() || at.sin.is_nan() {
        T::NAN
    } else if on_ray && reached {
        value
    } else {
        outside
    }
}

/// Points in the plane.
pub trait PlanarPoint<T: Real>: Planar<T> + Tangent<T> {
    /// Draws the point \[x, y\] itself. Randomness: [`Planar::sample`], then
    /// [`uniform::unit`] for [`Disk`](crate::Disk) alone.
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
    /// Draws the point \[x, y, z\] itself. Randomness: [`Spatial::sample`], then
    /// [`uniform::unit`] for [`Ball`](crate::Ball) alone.
    #[inline]
    fn sample_point<R: Rng + ?Sized>(&self, rho: Radius<T>, rng: &mut R) -> [T; 3] {
        let at = self.warp_tails(uniform::tails(rng));
        let azimuth = uniform::azimuth(rng);
        let r = self.sample_distance(rho, at, rng);
        crate::law::spherical(at, azimuth).map(|c| r * c)
    }
}

impl<T: Real, L: Spatial<T> + Tangent<T>> SpatialPoint<T> for L {}
