//! Every kernel against proven values.

extern crate std;

use super::series::Series;
use super::{Double, angle, arith, coefficients, disk, log_exp, root};
use crate::arithmetic::native::float::Float;
use std::string::String;
use std::vec::Vec;
use std::{format, println};

const REFERENCE: &str = include_str!("../../../tests/reference/double.csv");

/// log₂ of the relative error that each function may have.
const BOUNDS: &[(&str, f64)] = &[
    ("sqrt", -103.0),
    ("cbrt", -103.0),
    ("from_end", -105.0),
    ("pair_from_end", -98.0),
    ("sin_cos cos", -102.0),
    ("sin_cos sin", -102.0),
    ("at_angle cos", -102.0),
    ("at_angle sin", -102.0),
    ("at_eighth cos", -102.0),
    ("at_eighth sin", -102.0),
    ("atan2", -102.0),
    ("ln", -99.0),
    ("ln_1p", -99.0),
    ("exp", -95.0),
    ("exp_m1", -98.0),
    ("tail_at_angle", -100.0),
    ("tail_at_direction", -100.0),
    ("angle_at_tail", -101.0),
    ("direction_at_tail cos", -101.0),
    ("direction_at_tail sin", -101.0),
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
        let mut pair = || Double {
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
        "tail_at_direction" => disk::tail_at_direction(a, b),
        "angle_at_tail" => {
            let (x, at_end) = disk::angle_at_tail(a);
            assert_eq!(at_end, a.hi < 0.125);
            x
        }
        "direction_at_tail cos" => disk::direction_at_tail(a).cos,
        "direction_at_tail sin" => disk::direction_at_tail(a).sin,
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
            Double {
                hi: coefficients::SIN.full[0].hi,
                lo: 0.0,
            },
            coefficients::SIN.full[1],
            coefficients::SIN.full[2],
        ],
        ..coefficients::SIN
    };
    assert_eq!(PLANTED.full.len(), coefficients::SIN.full.len());
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
    assert!(worst(&coefficients::SIN) <= bound);
    assert!(worst(&PLANTED) > bound + 40.0);
}
