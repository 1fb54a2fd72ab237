//! Coefficients of the fast kernels, written by `python3 tools/coefficients.py`: do not edit.
//!
//! `FixedPoint`: constant term in Q(k + 16), the others in Qk, argument in Q16. Each error is relative,
//! certified by Sollya's `supnorm`, of the polynomial as stored; rounding comes on top.
#![allow(clippy::approx_constant, clippy::excessive_precision)] // the constants are the point

use super::fixed::FixedPoint;

/// Half of cbrt 1/2, in Q16.
pub(crate) const KEPLER_MIDDLE: i32 = 26008;

/// sqrt(1 + x); relative error 2^-13.78; k = 15
pub(crate) const SQRT: FixedPoint<3> = FixedPoint {
    first: 2147630387,
    rest: [16294, -3538, 818],
};

/// cbrt(1 + x); relative error 2^-13.66; k = 15
pub(crate) const CBRT: FixedPoint<3> = FixedPoint {
    first: 2147633438,
    rest: [10831, -3073, 760],
};

/// (1 + x)^(1/4); relative error 2^-13.79; k = 15
pub(crate) const FOURTH_ROOT: FixedPoint<3> = FixedPoint {
    first: 2147635172,
    rest: [8106, -2552, 646],
};

/// 2 sin(pi y / 4) / y in y^2; relative error 2^-18.28; k = 15
pub(crate) const TURN_SIN: FixedPoint<2> = FixedPoint {
    first: 3373265898,
    rest: [-5291, 160],
};

/// cos(pi y / 4) in y^2; relative error 2^-16.14; k = 15
pub(crate) const TURN_COS: FixedPoint<2> = FixedPoint {
    first: 2147461602,
    rest: [-10100, 503],
};

/// cos theta / z in z^2, z = cbrt p, p <= 1/2; relative error 2^-14.08; k = 15
pub(crate) const KEPLER_COS: FixedPoint<4> = FixedPoint {
    first: 3600133312,
    rest: [-15231, -8135, 4591, -12513],
};

/// sin theta / 2d in z - KEPLER_MIDDLE, z = cbrt p, d = 1/2 - p; relative error 2^-13.47; k = 15
pub(crate) const KEPLER_SIN: FixedPoint<5> = FixedPoint {
    first: 1898243808,
    rest: [-12546, 3947, 18737, -13590, 29677],
};

/// theta / (pi d) in z - KEPLER_MIDDLE, z = cbrt p, d = 1/2 - p; relative error 2^-13.93; k = 15
pub(crate) const KEPLER_ANGLE: FixedPoint<6> = FixedPoint {
    first: 1381385797,
    rest: [-21250, 22812, -1787, -6542, 35681, 17371],
};

/// 2^x; relative error 2^-17.98; k = 15
pub(crate) const EXP2: FixedPoint<4> = FixedPoint {
    first: 2147485408,
    rest: [22709, 7910, 1705, 444],
};

/// (2^x - 1) / x, x <= 0; relative error 2^-14.15; k = 15
pub(crate) const EXP2_M1: FixedPoint<2> = FixedPoint {
    first: 1488440212,
    rest: [7830, 1597],
};

/// sin x / x in x^2, |x| <= pi / 2; relative error 2^-13.17
pub(crate) const SIN: [f32; 3] = [0.99989176, -0.16595979, 0.007602733];

/// the same, finer: cosines are raised to powers; relative error 2^-20.0
pub(crate) const COS: [f32; 4] = [0.99999905, -0.1666555, 0.008311862, -0.00018487222];

/// sin(pi x) / x in x^2, x <= 1/2; relative error 2^-13.17
pub(crate) const HALF_TURN: [f32; 3] = [3.1412528, -5.145805, 2.3266373];

/// sin(2 pi x) / x in x^2, |x| <= 1/8; relative error 2^-19.33
pub(crate) const EIGHTH_SIN: [f32; 3] = [6.283176, -41.3311, 79.81175];

/// cos(2 pi x) in x^2, |x| <= 1/8; relative error 2^-16.37
pub(crate) const EIGHTH_COS: [f32; 3] = [0.9999882, -19.726788, 62.906235];

/// atan x / x in x^2, |x| <= 1; relative error 2^-15.02
pub(crate) const ATAN: [f32; 5] = [0.99997, -0.33170065, 0.18521503, -0.09192573, 0.023863038];

/// 2 atanh z / z in z^2, |z| <= 3 - 2 sqrt 2; relative error 2^-23.0
pub(crate) const LN: [f32; 3] = [2.0000002, 0.666522, 0.41297174];

/// p / eta^3 in eta^2, eta <= pi / 2; relative error 2^-16.33
pub(crate) const TAIL_OF_ANGLE: [f32; 4] = [0.21220401, -0.04241085, 0.0039830045, -0.00018663991];

/// p / cos^3 in sin; relative error 2^-13.23
pub(crate) const TAIL_OF_SINE: [f32; 6] = [
    0.4999481,
    -0.6329124,
    0.70401925,
    -0.621926,
    0.3535474,
    -0.09049177,
];
