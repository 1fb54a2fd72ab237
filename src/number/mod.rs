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
/// `f32` is computed in `f32` alone, on every target. What each type costs and how well it does is in the
/// tables of [`accuracy`](crate::accuracy).
pub trait Real: tier::Tier {}
