//! Which exponents `CosPower` admits.

use crate::number::Real;
use core::fmt;

/// Why an exponent was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ExponentError {
    /// The exponent is NaN.
    NotANumber,
    /// The exponent is negative.
    Negative,
    /// The exponent is infinite.
    Infinite,
}

impl fmt::Display for ExponentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ExponentError::NotANumber => "the exponent is NaN; expected a finite number ≥ 0",
            ExponentError::Negative => "the exponent is negative; expected a finite number ≥ 0",
            ExponentError::Infinite => "the exponent is infinite; expected a finite number ≥ 0",
        })
    }
}

impl core::error::Error for ExponentError {}

/// k, of −0 as 0, if it is finite and not negative.
#[inline(always)]
pub(super) fn admitted<T: Real>(k: T) -> Result<T, ExponentError> {
    if k.is_nan() {
        Err(ExponentError::NotANumber)
    } else if k < T::ZERO {
        Err(ExponentError::Negative)
    } else if !k.is_finite() {
        Err(ExponentError::Infinite)
    } else {
        Ok(k.abs())
    }
}
