//! Constants and series of the double-double kernels, written by `python3 tools/coefficients.py`: do not edit.
#![allow(clippy::approx_constant)] // the constants are the point

use super::arith::Double;
use super::series::Series;

// pi / 2
pub(crate) const HALF_PI: [f64; 3] = [
    1.5707963267948966,
    6.123233995736766e-17,
    -1.4973849048591698e-33,
];
// pi / 4
pub(crate) const QUARTER_PI: Double = Double {
    hi: 0.7853981633974483,
    lo: 3.061616997868383e-17,
};
// pi
pub(crate) const PI: Double = Double {
    hi: 3.141592653589793,
    lo: 1.2246467991473532e-16,
};
// 2 pi
pub(crate) const TWO_PI: Double = Double {
    hi: 6.283185307179586,
    lo: 2.4492935982947064e-16,
};
// 1 / pi
pub(crate) const RECIP_PI: Double = Double {
    hi: 0.3183098861837907,
    lo: -1.9678676675182486e-17,
};
// ln 2
pub(crate) const LN_2: Double = Double {
    hi: 0.6931471805599453,
    lo: 2.3190468138462996e-17,
};
// ln 2; the first two words of 32 bits, so that n times them is exact
pub(crate) const LN_2_SHORT: [f64; 3] = [
    0.6931471806019545,
    -4.200915072890502e-11,
    2.0941744292700725e-21,
];

// (sin x - x) / x^3 in x^2, |x| <= 0.9; error 2^-108.0 of the result
pub(crate) const SIN: Series = Series {
    full: &[
        Double {
            hi: -0.16666666666666666,
            lo: -9.251858538542968e-18,
        },
        Double {
            hi: 0.008333333333333333,
            lo: 1.1564823173082607e-19,
        },
        Double {
            hi: -0.0001984126984126984,
            lo: -1.7209553668570416e-22,
        },
    ],
    middle: &[
        Double {
            hi: 2.7557319223985893e-6,
            lo: -1.8584020713660748e-22,
        },
        Double {
            hi: -2.505210838544172e-8,
            lo: 1.4574368513444335e-24,
        },
        Double {
            hi: 1.605904383682161e-10,
            lo: -1.0982214597401813e-26,
        },
        Double {
            hi: -7.647163731818048e-13,
            lo: -2.6562169176647254e-29,
        },
    ],
    plain: &[
        2.8114572539390115e-15,
        -8.220634645765202e-18,
        1.9572389244051425e-20,
        -3.839505529633691e-23,
    ],
};

// (atanh z - z) / z^3 in z^2, |z| <= 3 - sqrt 8; error 2^-100.8 of the result
pub(crate) const ATANH: Series = Series {
    full: &[
        Double {
            hi: 0.3333333333333333,
            lo: 1.850371707710146e-17,
        },
        Double {
            hi: 0.2,
            lo: -1.1102230424187237e-17,
        },
    ],
    middle: &[
        Double {
            hi: 0.14285714285714285,
            lo: 7.930502453197285e-18,
        },
        Double {
            hi: 0.1111111111111111,
            lo: 5.9157486245318076e-18,
        },
        Double {
            hi: 0.09090909090909101,
            lo: -1.974716638726286e-18,
        },
        Double {
            hi: 0.07692307692305442,
            lo: -5.1856618632506625e-18,
        },
        Double {
            hi: 0.06666666666999331,
            lo: -6.82283557721435e-18,
        },
        Double {
            hi: 0.05882352908271294,
            lo: 2.561238358771639e-18,
        },
    ],
    plain: &[
        0.05263160119039031,
        0.04761801771581822,
        0.04351033781078264,
        0.03935993243713037,
        0.044350557639800815,
    ],
};

// (r coth r/2 - 2) / r^2 in r^2, |r| <= 0.35; error 2^-99.04 of the result
pub(crate) const COTH: Series = Series {
    full: &[Double {
        hi: 0.16666666666666666,
        lo: 9.251858538522503e-18,
    }],
    middle: &[
        Double {
            hi: -0.002777777777777778,
            lo: 1.0601090613668182e-19,
        },
        Double {
            hi: 6.613756613756614e-5,
            lo: -4.466028424270506e-21,
        },
        Double {
            hi: -1.6534391534391529e-6,
            lo: -7.321433980188789e-23,
        },
        Double {
            hi: 4.1753513975715514e-8,
            lo: -4.32322441656663e-25,
        },
    ],
    plain: &[
        -1.056838027249852e-9,
        2.676506630620388e-11,
        -6.778814919699118e-13,
        1.6934100214254168e-14,
    ],
};
