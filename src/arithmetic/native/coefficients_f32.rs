//! Constants and coefficients for f32, written by `python3 tools/coefficients.py`: do not edit.
#![allow(clippy::approx_constant)] // the constants are the point

use super::pair::Pair;
use super::table::{Part, Table};
use crate::arithmetic::constants::Constants;

pub(crate) const CONSTANTS: Constants<Pair<f32>> = Constants {
    // pi / 2
    half_pi: Pair {
        hi: 1.5707964,
        lo: -4.371139e-8,
    },
    // 2 pi
    two_pi: Pair {
        hi: 6.2831855,
        lo: -1.7484555e-7,
    },
    // pi
    pi: Pair {
        hi: 3.1415927,
        lo: -8.742278e-8,
    },
    // 1 / pi
    recip_pi: Pair {
        hi: 0.31830987,
        lo: 1.28412765e-8,
    },
    // 2 / pi
    two_over_pi: Pair {
        hi: 0.63661975,
        lo: 2.5682553e-8,
    },
    // 1 / (2 pi)
    recip_two_pi: Pair {
        hi: 0.15915494,
        lo: 6.4206382e-9,
    },
    // 12 pi
    twelve_pi: Pair {
        hi: 37.699112,
        lo: -9.5399045e-8,
    },
    // 3 / 2 pi
    three_over_two_pi: Pair {
        hi: 0.47746482,
        lo: 4.3607535e-9,
    },
    // 2 / 3 pi
    two_over_three_pi: Pair {
        hi: 0.21220659,
        lo: 3.5937973e-9,
    },
    // ln 2
    ln_2: Pair {
        hi: 0.6931472,
        lo: -1.9046542e-9,
    },
    // ln 2 pi
    ln_two_pi: Pair {
        hi: 1.837877,
        lo: 3.1268353e-8,
    },
    // ln pi
    ln_pi: Pair {
        hi: 1.1447299,
        lo: 3.317301e-8,
    },
    // ln 2 / pi
    ln_two_over_pi: Pair {
        hi: -0.4515827,
        lo: -5.2753406e-9,
    },
    // ln 3 / 2 pi
    ln_three_over_two_pi: Pair {
        hi: -0.7392648,
        lo: 8.5022025e-9,
    },
};

pub(crate) const TABLE: Table<f32> = Table {
    // (sin x - x) / x^3 in x^2, |x| <= 0.9; relative error 2^-25.0
    sin: &[-0.16666667, 0.008333379, -0.00019851352, 2.8005945e-6],
    // (cos x - 1 + x^2 / 2) / x^4 in x^2, |x| <= 0.9; relative error 2^-22.68
    cos: &[0.04166666, -0.0013887796, 2.4460596e-5],
    // (sin 2 pi x / x - 2 pi) / x^2 in x^2, |x| <= 1/8; relative error 2^-22.94
    sin_turn: &[-41.341698, 81.59961, -75.7304],
    // (cos 2 pi x - 1) / x^2 in x^2, |x| <= 1/8; relative error 2^-25.02
    cos_turn: &[-19.739208, 64.93908, -85.411865, 58.07624],
    // (eta / s - 1/2) / s^2 in s^2, s = cbrt(12 pi p), p <= 1/8; relative error 2^-24.0
    kepler_tail: &[
        0.008333333,
        0.00035715045,
        1.9814624e-5,
        1.2827842e-6,
        6.184259e-8,
        1.1937253e-8,
    ],
    // (theta / d - pi/2) / d^2 in d^2, d = 1/2 - p, p >= 1/8; relative error 2^-23.68
    kepler_centre: &[
        1.2919283, 2.550064, 6.460003, 17.086395, 97.77678, -605.1817, 8857.953, -45092.055,
        124932.63,
    ],
    // (p / eta^3 - 2 / 3 pi) / eta^2 in eta^2, eta <= pi / 2; relative error 2^-24.74
    disk_tail: &[
        -0.04244132,
        0.004042042,
        -0.00022458252,
        8.1879825e-6,
        -2.1770784e-7,
        4.952751e-9,
    ],
    // (p / c^3 - 2 / 3 pi) / c^2 in c^2, c <= sqrt 1/2; relative error 2^-25.9
    disk_tail_of_cos: &[
        0.06366198,
        0.034104377,
        0.022119213,
        0.015531876,
        0.014958068,
        -0.0061523775,
        0.055874284,
        -0.072937444,
        0.06471167,
    ],
    // ((asin s + s cos) / pi - 2 s / pi) / s^3 in s^2, s <= sqrt 1/2; relative error 2^-25.82
    disk_centre_of_sin: &[
        -0.10610329,
        -0.015915692,
        -0.0056781946,
        -0.0028390896,
        -0.0010836135,
        -0.0027833215,
        0.0026867976,
        -0.0033673448,
    ],
    // (atan x - x) / x^3 in x^2, |x| <= 1/2; relative error 2^-24.98
    atan: &[
        -0.33333334,
        0.19999988,
        -0.14282323,
        0.110298686,
        -0.083272405,
        0.04358874,
    ],
    // (2 atanh s - 2 s) / s^3 in s^2, |s| <= 3 - sqrt 8; relative error 2^-21.68
    atanh: &[0.66666687, 0.39988565, 0.2958601],
    // (2^r - 1 - r ln 2) / r^2, |r| <= 1/2; relative error 2^-22.85
    exp2_bend: &[
        0.2402265,
        0.055503808,
        0.009618135,
        0.0013381555,
        0.00015429233,
    ],
    // (ln(1 + f) - its terms below f^4) / f^4, |f| <= 0.096; relative error 2^-22.05
    log_series: &[-0.25, 0.19999702, -0.16666375, 0.1441469, -0.12619166],
    // (sin x - its terms below x^7) / x^7 in x^2, x <= pi/4; relative error 2^-26.02
    sine_tail: &[-0.0001984127, 2.7557228e-6, -2.4936345e-8],
    // integral of cos^n over its leading term, in m^-2, m = (2n + 1)/4; asymptotic
    cosine_integral: &[
        1.0,
        -0.015625,
        0.0025634766,
        -0.0012798309,
        0.001343511,
        -0.0024328968,
        0.0067542377,
        -0.02663696,
    ],
    // n times the integral of theta cos^n less 1 - 2/3n, over 1/n^2, in 1/n; asymptotic
    angle_integral: &[
        0.26666668,
        0.07619048,
        -0.15238096,
        -0.13852814,
        0.34525475,
        0.53706294,
        -1.6357603,
        -3.6015337,
        13.091361,
        37.228836,
        -157.98863,
        -550.2501,
    ],
    // significand from, factor, log2 of its inverse
    log_parts: [
        Part {
            from: 0.6484375,
            factor: 1.40625,
            log: Pair {
                hi: -0.49194336,
                lo: 9.026304e-5,
            },
        },
        Part {
            from: 0.771,
            factor: 1.1875,
            log: Pair {
                hi: -0.24804688,
                lo: 0.00011936155,
            },
        },
        Part {
            from: 0.917,
            factor: 1.0,
            log: Pair { hi: 0.0, lo: 0.0 },
        },
        Part {
            from: 1.0905,
            factor: 0.84375,
            log: Pair {
                hi: 0.24511719,
                lo: -4.6896635e-6,
            },
        },
    ],
    log_turn: 0.3515625,
    // log2 e, its first word half as long
    log2_e: Pair {
        hi: 1.4428711,
        lo: -0.00017605285,
    },
    // ln 2, its first word half as long
    ln_2: Pair {
        hi: 0.69311523,
        lo: 3.1946183e-5,
    },
    // 1 / 3, its first word of 13 bits
    third: Pair {
        hi: 0.333313,
        lo: 2.0345053e-5,
    },
    // what half_pi leaves
    half_pi_rest: -1.7151245e-15,
    // coefficients of x^3, x^5, ... in sin x, those that sine_tail leaves
    sine_head: &[
        Pair {
            hi: -0.16666667,
            lo: 4.967054e-9,
        },
        Pair {
            hi: 0.008333334,
            lo: -4.346172e-10,
        },
    ],
};

/// 1 / sqrt(1 + x) in units of 2^-16; the root of sqrt.rs errs by a spread of 0.29 ulp before it is corrected
pub(crate) const RECIPROCAL_ROOT: [i32; 5] = [65532, -32503, 22189, -12191, 3320];
