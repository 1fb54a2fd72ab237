//! The point that a law normalises: its measure, and its formulas.

use super::formulas::Parameterless;
use crate::CosSin;
use crate::arithmetic::kernel::Kernel;

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

/// A law whose direction comes from a point of the tangent disk, circle, ball or sphere: what
/// [`Tangent`](crate::Tangent) promises, in an arithmetic W.
pub trait Point: Parameterless {
    const MEASURE: Measure;
    const IS_PLANAR: bool;
    /// Whether the point lies anywhere on its ray, not only where that leaves the disk or ball.
    const IS_SOLID: bool = false;

    /// How far along its ray the point lies, for a uniform v in \[0, 1\].
    #[inline]
    fn share<W: Kernel>(_: W) -> W {
        W::ONE
    }
    /// Density of a point on the ray, for the radius ρ.
    fn point_density<W: Kernel>(rho: W, at: CosSin<W>) -> W;
    /// Its natural logarithm, where it may be beyond the arithmetic's range.
    fn ln_point_density<W: Kernel>(rho: W, at: CosSin<W>) -> W;
}
