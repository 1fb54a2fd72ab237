//! The laws of each format as bounds for generic code.

use super::law::Formulas;
use super::q15::Q15;
use super::q31::Q31;
use crate::law::Point;
use ::fixed::types::{I1F15, I1F31, U0F16};

/// The laws that [`Fixed`](type@crate::Fixed) knows: all of the crate, `CosPower` as
/// [`integers::CosPower`](super::CosPower). Sealed.
///
/// `L::Direction` is what a sample is, `[I1F31; 2]` or `[I1F31; 3]`; `L::Density` is `U0F32`, of
/// [`CosPower`](super::CosPower) `U16F16`, and can do what any unsigned number of the `fixed` crate
/// can.
///
/// ```
/// use coslobe::integers::{FixedLaw, FixedSpatial};
/// use coslobe::{Fixed, rand_core::Rng};
/// use fixed::types::I1F31;
/// fn density_at_axis<L: FixedLaw>(law: L) -> f64 {
///     let at = coslobe::CosSin { cos: I1F31::MAX, sin: I1F31::ZERO };
///     fixed::traits::Fixed::to_num(Fixed(law).density(at))
/// }
/// fn around<L: FixedSpatial, R: Rng>(law: L, normal: [I1F31; 3], rng: &mut R) -> [I1F31; 3] {
///     Fixed(law).sample_around(normal, rng)
/// }
/// # let _ = density_at_axis::<coslobe::Ball>;
/// ```
pub trait FixedLaw: Formulas<Q31> {}

impl<L: Formulas<Q31>> FixedLaw for L {}

/// Those in the plane. Sealed.
pub trait FixedPlanar: FixedLaw + Formulas<Q31, Direction = [I1F31; 2]> {}

impl<L: Formulas<Q31, Direction = [I1F31; 2]>> FixedPlanar for L {}

/// Those in space, [`CosPower`](super::CosPower) among them. Sealed.
pub trait FixedSpatial: FixedLaw + Formulas<Q31, Direction = [I1F31; 3]> {}

impl<L: Formulas<Q31, Direction = [I1F31; 3]>> FixedSpatial for L {}

/// The laws that [`Fixed16`](type@crate::Fixed16) knows: those without a parameter. Sealed.
///
/// `L::Direction` is what a sample is, `[I1F15; 2]` or `[I1F15; 3]`; every density is a `U0F16`.
pub trait Fixed16Law: Formulas<Q15, Density = U0F16> {}

impl<L: Formulas<Q15, Density = U0F16>> Fixed16Law for L {}

/// Those in the plane. Sealed.
pub trait Fixed16Planar: Fixed16Law + Formulas<Q15, Direction = [I1F15; 2]> {}

impl<L> Fixed16Planar for L where L: Formulas<Q15, Density = U0F16, Direction = [I1F15; 2]> {}

/// Those in space. Sealed.
pub trait Fixed16Spatial: Fixed16Law + Formulas<Q15, Direction = [I1F15; 3]> {}

impl<L> Fixed16Spatial for L where L: Formulas<Q15, Density = U0F16, Direction = [I1F15; 3]> {}

/// Those whose direction comes from a point: all but [`CosPower`](super::CosPower). Sealed.
pub trait FixedTangent: FixedLaw + Point {}

impl<L: FixedLaw + Point> FixedTangent for L {}

/// The same in 16 bits: all six. Sealed.
pub trait Fixed16Tangent: Fixed16Law + Point {}

impl<L: Fixed16Law + Point> Fixed16Tangent for L {}
