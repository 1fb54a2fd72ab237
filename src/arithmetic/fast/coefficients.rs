//! Coefficients of the fast kernels, written by `python3 tools/coefficients.py`: do not edit.
//!
//! `FixedPoint`: argument in Q16, `last` in Qk, the others in Q(k + 16), `inner` with half a unit of Qk added. Each error is relative,
//! certified by Sollya's `supnorm`, of the polynomial as stored; rounding comes on top.
#![allow(clippy::approx_constant, clippy::excessive_precision)] // the constants are the point

use super::fixed::FixedPoint;

/// Tail of the disk's law below which a direction is measured from the end, else from the axis.
pub(crate) const KEPLER_SPLIT: f32 = 0.171875;

/// cbrt(1 - x), less 1; relative error 2^-16.58; k = 16
pub(crate) const CBRT: FixedPoint<3> = FixedPoint {
    first: 0,
    inner: [-1429214302, -518287210, -53766409],
    last: -8566,
};

/// 2 sin(pi y / 4) / y in y^2; relative error 2^-18.63; k = 15
pub(crate) const TURN_SIN: FixedPoint<1> = FixedPoint {
    first: 3373257640,
    inner: [-346702633],
    last: 160,
};

/// cos(pi y / 4) in y^2; relative error 2^-16.24; k = 15
pub(crate) const TURN_COS: FixedPoint<1> = FixedPoint {
    first: 2147455839,
    inner: [-661871212],
    last: 503,
};

/// cos theta / z in z^2 as cut off, z = cbrt p, p < KEPLER_SPLIT; relative error 2^-17.29; k = 15
pub(crate) const END_COS: FixedPoint<2> = FixedPoint {
    first: 3600346711,
    inner: [-1014092930, -354476730],
    last: -5604,
};

/// sin theta in the same; relative error 2^-16.78; k = 14
pub(crate) const END_SIN: FixedPoint<2> = FixedPoint {
    first: 1073727008,
    inner: [-1509823688, -200554305],
    last: -2195,
};

/// (pi/2 - theta) / z in the same; relative error 2^-17.5; k = 15
pub(crate) const END_ANGLE: FixedPoint<2> = FixedPoint {
    first: 3600332021,
    inner: [676597630, 296413120],
    last: 5099,
};

/// 2 sin theta / w in w^2 as cut off, w = 1 - 2 p; relative error 2^-16.62; k = 15
pub(crate) const CENTRE_SIN: FixedPoint<2> = FixedPoint {
    first: 3373232277,
    inner: [349120337, 115101172],
    last: 2325,
};

/// cos theta in the same; relative error 2^-14.89; k = 14
pub(crate) const CENTRE_COS: FixedPoint<2> = FixedPoint {
    first: 1073771400,
    inner: [-333448600, -95714360],
    last: -2115,
};

/// 2 theta / w in the same; relative error 2^-14.95; k = 15
pub(crate) const CENTRE_ANGLE: FixedPoint<2> = FixedPoint {
    first: 3373165249,
    inner: [700980505, 265300097],
    last: 6941,
};

/// 4^x - 2x, less 1; relative error 2^-17.8; k = 14
pub(crate) const EXP2: FixedPoint<3> = FixedPoint {
    first: 0,
    inner: [-659208862, 1037056800, 446259668],
    last: 3560,
};

/// (1 - 2^-y) / y, y = 2x; relative error 2^-15.47; k = 16
pub(crate) const EXP2_M1: FixedPoint<1> = FixedPoint {
    first: 2976978990,
    inner: [-2057327767],
    last: 13203,
};

/// sin x / x in x^2, |x| <= pi / 2; relative error 2^-13.17
pub(crate) const SIN: [f32; 3] = [0.99989176, -0.16595979, 0.007602733];

/// the same, finer: cosines are raised to powers; relative error 2^-20.0
pub(crate) const COS: [f32; 4] = [0.99999905, -0.1666555, 0.008311862, -0.00018487222];

/// sin(pi x) / x in x^2, x <= 1/2; relative error 2^-13.17
pub(crate) const HALF_TURN: [f32; 3] = [3.1412528, -5.145805, 2.3266373];

/// atan x / x in x^2, |x| <= 1; relative error 2^-15.02
pub(crate) const ATAN: [f32; 5] = [0.99997, -0.33170065, 0.18521503, -0.09192573, 0.023863038];

/// 2 atanh z / z in z^2, |z| <= 3 - 2 sqrt 2; relative error 2^-23.0
pub(crate) const LN: [f32; 3] = [2.0000002, 0.666522, 0.41297174];

/// 2 atanh z / z in z^2, shorter: for roots of probabilities; relative error 2^-15.45
pub(crate) const LN_SHORT: [f32; 2] = [1.9999554, 0.67868716];

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

/// Sine and cosine of 2 pi u are of T = s (s + AZIMUTH_SHIFT), s = u (1/2 - u), u <= 1/2.
pub(crate) const AZIMUTH_SHIFT: f32 = 0.43093058;

/// cos(2 pi u) / (1/4 - u) in T; relative error 2^-12.9
pub(crate) const AZIMUTH_COS: [f32; 2] = [3.9999962, 74.00809];

/// sin(2 pi u) / s - 16 s in T; relative error 2^-13.02
pub(crate) const AZIMUTH_SIN: [f32; 2] = [12.567881, 78.86349];
