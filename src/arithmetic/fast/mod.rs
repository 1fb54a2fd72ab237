//! Kernels of about 2⁻¹³ relative error, for half the bits of an `f32` at a fraction of the cost.
//!
//! A polynomial is evaluated in 32-bit integers where its argument is one already (a random word, a
//! significand), in `f32` where the argument is a float: without a floating-point unit an integer
//! step is some thirty times cheaper, with one the conversion would cost as much as it saves.

pub(crate) mod angle;
pub(crate) mod coefficients;
pub(crate) mod fixed;
pub(crate) mod kepler;
pub(crate) mod kernel;
pub(crate) mod power;
pub(crate) mod root;
pub(crate) mod uniform;

#[cfg(test)]
mod tests;
