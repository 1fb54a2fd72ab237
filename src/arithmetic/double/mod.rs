//! Double-double kernels, which the `Precise` tiers run on: relative error below 2⁻⁹⁵ or nearly so.
//!
//! Each function takes a result of plain f64 and corrects it once, or sums one short series. The
//! bounds hold while arguments and results lie between 2⁻⁴⁰⁰ and 2⁴⁰⁰; results are normalised, hi
//! = RN(hi + lo), and what is exact comes out with lo = 0. `two_prod` is off by at most one unit
//! of 2⁻¹⁰⁴: only the product of two trailing parts, of 27 bits each, can round.

pub(crate) mod angle;
pub(crate) mod arith;
pub(crate) mod coefficients;
mod constants;
pub(crate) mod disk;
#[cfg(test)]
mod hostile;
mod kernel;
pub(crate) mod log_exp;
pub(crate) mod nearest;
mod operators;
mod power;
pub(crate) mod root;
mod series;
#[cfg(test)]
mod tests;

pub(crate) use arith::Double;
