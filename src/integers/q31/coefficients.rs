//! Coefficients, written by `python3 tools/fixed_coefficients.py`: do not edit.
//!
//! Each error is absolute, certified by Sollya's `supnorm`, of the polynomial as stored; rounding
//! comes on top.

use crate::integers::kernel::poly::Polynomial;

/// 3/4 of (1/2)^(2/3), in Q32.
pub(crate) const KEPLER_MIDDLE: u32 = 2029244888;

/// (1 - cos(pi y / 4)) / y^2 in y^2; x from 0.0 to 1.0; Q32; error 2^-36.85
pub(crate) const TURN_COS: Polynomial<u32, 3, 2> = Polynomial {
    small: [103, 15419, 1400123],
    large: [68093890, 1324675879],
};

/// sin(pi y / 4) / y in y^2; x from 0.0 to 1.0; Q32; error 2^-34.94
pub(crate) const TURN_SIN: Polynomial<u32, 2, 3> = Polynomial {
    small: [1325, 157072],
    large: [10696153, 346799332, 3373259426],
};

/// 1 / sqrt(1 - t); x from 0.0 to 0.5; Q14; error 2^-10.75
pub(crate) const RECIP_SQRT: Polynomial<i32, 4, 0> = Polynomial {
    small: [16062, 1689, 8712, 16375],
    large: [],
};

/// (1 - cbrt(1 - t)) / t in 2 t - 1/2; x from -0.5 to 0.5; Q32; error 2^-33.08
pub(crate) const CBRT: Polynomial<i32, 1, 10> = Polynomial {
    small: [937801],
    large: [
        1570019, 2063230, 3667141, 6807294, 12692665, 24674323, 51103547, 117190985, 326810612,
        1570922146,
    ],
};

/// 1 / (1 - t) in 2 t - 1/2; x from -0.5 to 0.5; Q14; error 2^-11.12
pub(crate) const RECIP: Polynomial<i32, 5, 0> = Polynomial {
    small: [5313, 7492, 9584, 14497, 21848],
    large: [],
};

/// asin s / (2 pi s) in s^2; x from 0.0 to 0.146448; Q32; error 2^-32.79
pub(crate) const ASIN: Polynomial<i32, 1, 5> = Polynomial {
    small: [22620648],
    large: [19310634, 30649918, 51261538, 113927655, 683565275],
};

/// eta / z - 1 in 3/2 z^2 - KEPLER_MIDDLE, z = cbrt p; x from -0.47247 to 0.472471; Q32; error
/// 2^-32.1
pub(crate) const KEPLER: Polynomial<i32, 1, 12> = Polynomial {
    small: [58805903],
    large: [
        61658209, 28440933, 37646757, 57479745, 69183994, 85016274, 110484614, 150791165,
        221758478, 371385110, 819518411, 611211335,
    ],
};

/// -log2(1 - t) / t - 3/2 in 2 t - 1/2; x from -0.5 to 0.5; Q31; error 2^-32.3
pub(crate) const LOG2: Polynomial<i32, 1, 11> = Polynomial {
    small: [4318052],
    large: [
        6667218, 7783980, 13292328, 23409440, 40206966, 70585810, 127895658, 242042132, 490962135,
        1131480745, 343919500,
    ],
};

/// 2^-(1/2 + g) - 1/2; x from -0.5 to 0.5; Q31; error 2^-34.63
pub(crate) const EXP2: Polynomial<i32, 2, 6> = Polynomial {
    small: [-23240, 234851],
    large: [
        -2024690,
        14604998,
        -84283003,
        364784016,
        -1052544167,
        444758426,
    ],
};

/// (1 - 2^-x) / x; x from 0.0 to 0.5; Q31; error 2^-32.9
pub(crate) const EXP2_M1: Polynomial<i32, 1, 5> = Polynomial {
    small: [-286461],
    large: [2839925, -20649113, 119193576, -515882477, 1488522236],
};
