//! Number types: a format and an accuracy tier at once, one a file.

mod f32;
mod f64;
mod fast;
mod precise;
pub(crate) mod tier;

pub use fast::Fast;
pub use precise::Precise;

/// A number type that the laws work in: [`prim@f32`], [`prim@f64`], [`Precise<f32>`](Precise),
/// [`Precise<f64>`](Precise) or [`Fast<f32>`](Fast).
///
/// Sealed. A law's formula is written once; its number type decides the arithmetic that runs it.
/// `f32` is computed in `f32` alone, on every target. What each type costs and how well it does is
/// in the tables of [`accuracy`](crate::accuracy).
///
/// Generic code may compute with a `T: Real`: by `+`, `-`, `*`, `/` and comparisons, with the
/// constants `T::ZERO`, `T::QUARTER`, `T::HALF`, `T::ONE`, `T::INFINITY` and `T::NAN`, by `T::int`
/// of an `i16`, and by the methods `abs`, `copysign`, `sqrt`, `is_nan` and `is_finite`. All are
/// those of the format, but `sqrt` of [`Fast<f32>`](Fast), which has its error. What else a `T:
/// Real` has is the crate's own and may change.
///
/// ```
/// use coslobe::{CosSin, Fast, Real};
/// /// Schlick's reflectance of a surface that reflects `r` of what falls along its normal.
/// fn reflectance<T: Real>(r: T, at: CosSin<T>) -> T {
///     let grazing = T::ONE - at.cos;
///     let square = grazing * grazing;
///     r + (T::ONE - r) * (square * square * grazing)
/// }
/// assert_eq!(reflectance(0.25f64, CosSin { cos: 0.0, sin: 1.0 }), 1.0);
/// assert_eq!(reflectance(Fast(0.25f32), CosSin { cos: Fast(1.0), sin: Fast(0.0) }), Fast(0.25));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number type that the laws work in",
    label = "not `f32`, `f64`, `Fast<f32>`, `Precise<f32>` or `Precise<f64>`",
    note = "integers are served by `Fixed(law)` and `Fixed16(law)`, with the feature `fixed`"
)]
pub trait Real: tier::Tier {}
