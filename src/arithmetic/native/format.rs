//! A hardware format with what its kernels read.

use super::float::Float;
use super::pair::Pair;
use super::table::Table;
use crate::arithmetic::constants::Constants;

/// A hardware format with its constants and coefficients.
pub trait Native: Float {
    const CONSTANTS: Constants<Pair<Self>>;
    const TABLE: Table<Self>;
}
