//! The point before it was normalised.

use crate::arithmetic::constants::Constants;
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
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
    /// Rounded once at the end, so only an r below the smallest number becomes 0. Error < 4 ulp.
    #[inline]
    fn distance(&self, rho: Radius<T>, at: CosSin<T>, v: T) -> T {
        let share = match Self::MEASURE {
            Measure::Area => v.sqrt(),
            Measure::Volume => cube_root(v),
            _ => T::ONE,
        };
        (rho.get() + rho.get()) * (at.cos * share)
    }

    /// Joint density of the point at distance `r` in direction `at`, per unit of
    /// [`MEASURE`](Tangent::MEASURE).
    ///
    /// 1/(πρ²) and 3/(4πρ³) inside the disk and ball, 0 for r > 2ρ cos θ; 1/(2πρ) and 1/(4πρ²) on
    /// the circle and sphere. For the shells the coefficient of δ(r − 2ρ cos θ) per dr dθ (dφ),
    /// which is the law's pdf. On curves, surfaces and shells `r` is not read. Overflows or
    /// underflows only where the value itself does: see
    /// [`ln_point_density`](Tangent::ln_point_density). Error < 4 ulp.
    #[inline]
    fn point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T {
        let (recip_rho, recip_pi) = (T::ONE / rho.get(), constant::<T>(|c| c.recip_pi));
        let value = match Self::MEASURE {
            Measure::Area => recip_pi / rho.get() * recip_rho,
            Measure::ArcLength => recip_pi * T::HALF / rho.get(),
            Measure::CircleShell => self.density(at),
            Measure::Volume => {
                constant::<T>(|c| c.three_over_two_pi) * T::HALF / rho.get() * recip_rho * recip_rho
            }
            Measure::SurfaceArea => recip_pi * T::QUARTER / rho.get() * recip_rho,
            Measure::SphereShell => self.density(at) * at.sin.abs(),
        };
        inside(Self::MEASURE, rho, at, r, value, T::ZERO)
    }

    /// Natural logarithm of [`point_density`](Tangent::point_density), finite for every radius.
    /// Error < 4 ulp of its larger term.
    #[inline]
    fn ln_point_density(&self, rho: Radius<T>, at: CosSin<T>, r: T) -> T {
        let (ln_rho, ln_pi, ln_2) = (
            ln(rho.get()),
            constant::<T>(|c| c.ln_pi),
            constant::<T>(|c| c.ln_2),
        );
        let value = match Self::MEASURE {
            Measure::Area => -(ln_pi + ln_rho * T::int(2)),
            Measure::ArcLength => -(constant::<T>(|c| c.ln_two_pi) + ln_rho),
            Measure::CircleShell => ln(self.density(at)),
            Measure::Volume => {
                constant::<T>(|c| c.ln_three_over_two_pi) - (ln_2 + ln_rho * T::int(3))
            }
            Measure::SurfaceArea => -(ln_pi + (ln_2 + ln_rho) * T::int(2)),
            Measure::SphereShell => ln(self.density(at)) + ln(at.sin.abs()),
        };
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

/// An exact constant, rounded to the format.
#[inline(always)]
fn constant<T: Real>(of: impl Fn(&Constants<Pair<T::Base>>) -> Pair<T::Base>) -> T {
    T::from_base(of(&<T::Base as Native>::CONSTANTS).value())
}

#[inline]
fn ln<T: Real>(x: T) -> T {
    let [ln] = T::rounded(
        Margin::Relative,
        || [T::Quick::from_number(x).ln()],
        || [T::Accurate::from_number(x).ln()],
    );
    ln
}

#[inline]
fn cube_root<T: Real>(x: T) -> T {
    let [root] = T::rounded(
        Margin::Relative,
        || [T::Quick::from_number(x).cbrt()],
        || [T::Accurate::from_number(x).cbrt()],
    );
    root
}
