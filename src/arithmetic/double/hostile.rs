//! What the kernels do at zeros, infinities and NaN, and beside their range.

extern crate std;

use super::arith::Double;
use super::{angle, disk, log_exp, root};
use crate::CosSin;

#[test]
fn the_angle_of_zeros_and_infinities_is_that_of_std() {
    let values = [0.0, -0.0, 1.0, -1.0, f64::INFINITY, f64::NEG_INFINITY];
    for y in values {
        for x in values {
            let got = angle::atan2(Double::from_f64(y), Double::from_f64(x)).hi;
            let want = std::primitive::f64::atan2(y, x);
            assert_eq!(got.to_bits(), want.to_bits(), "atan2({y}, {x})");
        }
    }
}

#[test]
fn no_argument_panics_and_nan_stays() {
    let hostile = [
        0.0,
        -0.0,
        5e-324,
        -1.0,
        0.7,
        1e300,
        -1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];
    for a in hostile {
        for b in hostile {
            let (x, y) = (Double::from_f64(a), Double::from_f64(b));
            let CosSin { cos, sin } = angle::sin_cos(x);
            let turned = angle::at_eighth(x);
            let folded = angle::at_angle(a);
            let pair = disk::direction_at_tail(x);
            let (exp, _) = log_exp::exp(x);
            let (angle, _) = disk::angle_at_tail(x);
            let of_one = [
                root::sqrt(x),
                root::cbrt(x),
                angle::from_end(a),
                angle::pair_from_end(x),
                cos,
                sin,
                turned.cos,
                turned.sin,
                folded.cos,
                folded.sin,
                log_exp::ln(x),
                log_exp::ln_1p(x),
                exp,
                log_exp::exp_m1(x),
                disk::tail_at_angle(a),
                angle,
                pair.cos,
                pair.sin,
            ];
            for (i, value) in of_one.iter().enumerate() {
                assert!(!a.is_nan() || value.hi.is_nan(), "{i} at NaN: {value:?}");
            }
            let of_two = [angle::atan2(x, y), disk::tail_at_direction(x, y)];
            for value in of_two {
                assert!(
                    !(a.is_nan() && b.is_nan()) || value.hi.is_nan(),
                    "{value:?}"
                );
            }
        }
    }
}
