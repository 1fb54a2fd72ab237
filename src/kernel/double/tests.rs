//! Every kernel against proven values, and what it does beside and outside its range.

extern crate std;

use super::series::Series;
use super::{Double, angle, arith, disk, log_exp, root, table};
use crate::CosSin;
use crate::kernel::pair::Pair;
use crate::number::native::Native;
use std::string::String;
use std::vec::Vec;
use std::{format, println};

const REFERENCE: &str = include_str!("../../../tests/reference/double.csv");

/// log₂ of the relative error that each function may have.
const BOUNDS: &[(&str, f64)] = &[
    ("sqrt", -95.0),
    ("cbrt", -95.0),
    ("from_end", -95.0),
    ("pair_from_end", -95.0),
    ("sin_cos cos", -95.0),
    ("sin_cos sin", -95.0),
    ("at_angle cos", -95.0),
    ("at_angle sin", -95.0),
    ("at_eighth cos", -95.0),
    ("at_eighth sin", -95.0),
    ("atan2", -95.0),
    ("ln", -95.0),
    ("ln_1p", -95.0),
    ("exp", -95.0),
    ("exp_m1", -95.0),
    ("tail_at_angle", -95.0),
    ("tail_at_pair", -95.0),
    ("angle_at_tail", -95.0),
    ("pair_at_tail cos", -95.0),
    ("pair_at_tail sin", -95.0),
];

struct Row<'a> {
    function: &'a str,
    first: Double,
    second: Double,
    value: [f64; 3],
}

fn rows() -> impl Iterator<Item = Row<'static>> {
    REFERENCE.lines().skip(1).map(|line| {
        let mut fields = line.split(',');
        let function = fields.next().unwrap();
        let mut word = || match fields.next() {
            None | Some("") => 0.0,
            Some(hex) => f64::from_bits(u64::from_str_radix(hex, 16).unwrap()),
        };
        let mut pair = || Pair {
            hi: word(),
            lo: word(),
        };
        let (first, second) = (pair(), pair());
        Row {
            function,
            first,
            second,
            value: [word(), word(), word()],
        }
    })
}

fn call(row: &Row) -> Double {
    let (a, b) = (row.first, row.second);
    match row.function {
        "sqrt" => root::sqrt(a),
        "cbrt" => root::cbrt(a),
        "from_end" => angle::from_end(a.hi),
        "pair_from_end" => angle::pair_from_end(a),
        "sin_cos cos" => angle::sin_cos(a).cos,
        "sin_cos sin" => angle::sin_cos(a).sin,
        "at_angle cos" => angle::at_angle(-a.hi).cos,
        "at_angle sin" => angle::at_angle(a.hi).sin,
        "at_eighth cos" => angle::at_eighth(a).cos,
        "at_eighth sin" => angle::at_eighth(a).sin,
        "atan2" => angle::atan2(a, b),
        "ln" => log_exp::ln(a),
        "ln_1p" => log_exp::ln_1p(a),
        "exp" => {
            let (m, n) = log_exp::exp(a);
            assert!((0.5..2.0).contains(&m.hi), "{m:?}");
            arith::scaled(m, 1.0_f64.scale(n - b.hi as i32))
        }
        "exp_m1" => log_exp::exp_m1(a),
        "tail_at_angle" => disk::tail_at_angle(a.hi),
        "tail_at_pair" => disk::tail_at_pair(a, b),
        "angle_at_tail" => {
            let (x, at_end) = disk::angle_at_tail(a);
            assert_eq!(at_end, a.hi < 0.125);
            x
        }
        "pair_at_tail cos" => disk::pair_at_tail(a).cos,
        "pair_at_tail sin" => disk::pair_at_tail(a).sin,
        unknown => panic!("{unknown}"),
    }
}

/// log₂ of the relative error; an exact value must be met exactly.
fn error(got: Double, value: [f64; 3]) -> f64 {
    let off = (got.hi - value[0]) + ((got.lo - value[1]) - value[2]);
    if off == 0.0 {
        f64::NEG_INFINITY
    } else if value[1] == 0.0 && value[2] == 0.0 {
        f64::INFINITY
    } else {
        libm::log2((off / value[0]).abs())
    }
}

#[test]
fn every_kernel_is_within_its_bound() {
    let mut worst: Vec<(f64, String, usize)> = BOUNDS
        .iter()
        .map(|_| (f64::NEG_INFINITY, String::new(), 0))
        .collect();
    for row in rows() {
        let i = BOUNDS.iter().position(|b| b.0 == row.function).unwrap();
        let got = call(&row);
        let shown = || {
            format!(
                "{}({:e} + {:e}, {:e} + {:e}) = {got:?}, not {:?}",
                row.function, row.first.hi, row.first.lo, row.second.hi, row.second.lo, row.value
            )
        };
        assert!(got.hi + got.lo == got.hi, "not normalised: {}", shown());
        let error = error(got, row.value);
        worst[i].2 += 1;
        if error.is_nan() || error >= worst[i].0 {
            worst[i].0 = error;
            worst[i].1 = shown();
        }
    }
    for ((name, _), (error, shown, n)) in BOUNDS.iter().zip(&worst) {
        println!("{name:17} 2^{error:7.2} of {n:4}: {shown}");
        assert!(*n > 100, "{name}: {n} rows");
    }
    for ((name, bound), (error, shown, _)) in BOUNDS.iter().zip(&worst) {
        assert!(error <= bound, "{name}: 2^{error:.2} > 2^{bound}: {shown}");
    }
}

/// A series whose leading coefficient lost its low word, as a wrong generator would write it.
#[test]
fn a_dropped_low_word_is_caught() {
    const PLANTED: Series = Series {
        full: &[
            Pair {
                hi: table::SIN.full[0].hi,
                lo: 0.0,
            },
            table::SIN.full[1],
            table::SIN.full[2],
            table::SIN.full[3],
        ],
        ..table::SIN
    };
    assert_eq!(PLANTED.full.len(), table::SIN.full.len());
    let bound = BOUNDS.iter().find(|b| b.0 == "sin_cos sin").unwrap().1;
    let worst = |series: &Series| {
        rows()
            .filter(|row| row.function == "sin_cos sin")
            .map(|row| {
                let sin = arith::add_smaller(row.first, angle::sine_gap(row.first, series));
                error(sin, row.value)
            })
            .fold(f64::NEG_INFINITY, f64::max)
    };
    assert!(worst(&table::SIN) <= bound);
    assert!(worst(&PLANTED) > bound + 20.0);
}

#[test]
fn the_angle_of_zeros_and_infinities_is_that_of_std() {
    let values = [0.0, -0.0, 1.0, -1.0, f64::INFINITY, f64::NEG_INFINITY];
    for y in values {
        for x in values {
            let got = angle::atan2(Pair::exact(y), Pair::exact(x)).hi;
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
            let (x, y) = (Pair::exact(a), Pair::exact(b));
            let CosSin { cos, sin } = angle::sin_cos(x);
            let turned = angle::at_eighth(x);
            let folded = angle::at_angle(a);
            let pair = disk::pair_at_tail(x);
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
            let of_two = [angle::atan2(x, y), disk::tail_at_pair(x, y)];
            for value in of_two {
                assert!(
                    !(a.is_nan() && b.is_nan()) || value.hi.is_nan(),
                    "{value:?}"
                );
            }
        }
    }
}
