//! Coefficients, written by `python3 tools/fixed_coefficients.py`: do not edit.
//!
//! Each error is absolute, certified by Sollya's `supnorm`, of the polynomial as stored; rounding
//! comes on top.

use crate::integers::kernel::poly::Polynomial;

/// 3/4 of (1/2)^(2/3), in Q32.
pub(crate) const KEPLER_MIDDLE: u32 = 2029244888;

/// (1 - cos(pi y / 4)) / y^2 in y^2; x from 0.0 to 1.0; Q17; error 2^-20.3
pub(crate) const TURN_COS: Polynomial<u32, 3, 0> = Polynomial {
    small: [42, 2078, 40426],
    large: [],
};

/// sin(pi y / 4) / y in y^2; x from 0.0 to 1.0; Q16; error 2^-18.37
pub(crate) const TURN_SIN: Polynomial<u32, 3, 0> = Polynomial {
    small: [160, 5291, 51472],
    large: [],
};

/// (1 - sqrt m) / (1 - m) in 2 m - 1; x from 0.0 to 1.0; Q16; error 2^-17.1
pub(crate) const SQRT: Polynomial<u32, 5, 0> = Polynomial {
    small: [368, 1508, 3451, 7933, 38390],
    large: [],
};

/// (1 - cbrt m) / (1 - m) in 2 m - 1; x from 0.0 to 1.0; Q16; error 2^-16.58
pub(crate) const CBRT: Polynomial<u32, 5, 0> = Polynomial {
    small: [441, 1728, 3710, 7617, 27040],
    large: [],
};

/// 1 / 2 m in 2 m - 1; x from 0.0 to 1.0; Q16; error 2^-19.43
pub(crate) const RECIP: Polynomial<u32, 8, 0> = Polynomial {
    small: [3407, 16811, 38111, 55592, 63442, 65317, 65528, 65536],
    large: [],
};

/// asin s / (2 pi s) in s^2; x from 0.0 to 0.146691; Q17; error 2^-19.04
pub(crate) const ASIN: Polynomial<i32, 3, 0> = Polynomial {
    small: [1815, 3460, 20861],
    large: [],
};

/// eta / z - 1 in 3/2 z^2 - KEPLER_MIDDLE, z = cbrt p; x from -0.47247 to 0.472715; Q17; error
/// 2^-18.61
pub(crate) const KEPLER: Polynomial<i32, 8, 0> = Polynomial {
    small: [3351, 3284, 3065, 4567, 6795, 11328, 25009, 18653],
    large: [],
};
