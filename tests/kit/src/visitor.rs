//! Who is shown laws and number types, and what is known of them then.

use crate::{Id, Number};
use ::fixed::types::{I1F15, I1F31, U0F32};
use core::fmt::Debug;
use coslobe::integers::{
    CosPower, Fixed16Law, Fixed16Planar, Fixed16Spatial, Fixed16Tangent, FixedLaw, FixedPlanar,
    FixedSpatial, FixedTangent,
};
use coslobe::{PlanarPoint, Spatial, SpatialPoint};

/// A law's type, by its name.
pub trait Named {
    /// `CosPower` with [`EXPONENT`](crate::EXPONENT), whatever it has.
    const ID: Id;
}

/// A law of the plane, to be copied and shared.
pub trait PlanarLaw<T: Number>:
    PlanarPoint<T> + Named + Copy + Debug + Send + Sync + 'static
{
}

impl<T: Number, L: PlanarPoint<T> + Named + Copy + Debug + Send + Sync + 'static> PlanarLaw<T>
    for L
{
}

/// A law of space, to be copied and shared.
pub trait SpatialLaw<T: Number>: Spatial<T> + Named + Copy + Debug + Send + Sync + 'static {}

impl<T: Number, L: Spatial<T> + Named + Copy + Debug + Send + Sync + 'static> SpatialLaw<T> for L {}

/// A law of space that has points, to be copied and shared.
pub trait TangentLaw<T: Number>:
    SpatialPoint<T> + Named + Copy + Debug + Send + Sync + 'static
{
}

impl<T: Number, L: SpatialPoint<T> + Named + Copy + Debug + Send + Sync + 'static> TangentLaw<T>
    for L
{
}

/// Is shown laws, each with its own type.
pub trait LawVisitor<T: Number> {
    /// A law of the plane.
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L);
    /// A law of space.
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L);
    /// A law of space that has points.
    fn tangent<L: TangentLaw<T>>(&mut self, id: Id, law: L) {
        self.spatial(id, law);
    }
}

/// A law in integers of both formats.
pub trait IntegerLaw:
    FixedLaw<Density = U0F32, Direction: AsRef<[I1F31]> + Default + Debug>
    + Fixed16Law<Direction: AsRef<[I1F15]> + Default + Debug>
    + FixedTangent
    + Fixed16Tangent
    + Named
    + Default
    + Copy
    + 'static
{
}

impl<L> IntegerLaw for L where
    L: FixedLaw<Density = U0F32, Direction: AsRef<[I1F31]> + Default + Debug>
        + Fixed16Law<Direction: AsRef<[I1F15]> + Default + Debug>
        + FixedTangent
        + Fixed16Tangent
        + Named
        + Default
        + Copy
        + 'static
{
}

/// Is shown laws in integers.
pub trait IntegerVisitor {
    /// A law without a parameter.
    fn law<L: IntegerLaw>(&mut self, law: L);
    /// The same for whom its directions' types matter: a law of the plane.
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, law: L) {
        self.law(law);
    }
    /// And one of space.
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        self.law(law);
    }
    /// `CosPower`, which has 32 bits alone, with the exponent nearest to
    /// [`EXPONENT`](crate::EXPONENT).
    fn power(&mut self, _: CosPower) {}
}

/// Is shown number types.
pub trait NumberVisitor {
    /// One of them.
    fn number<T: Number>(&mut self);
}
