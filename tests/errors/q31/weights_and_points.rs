//! Weights on every cosine, distances over radii, cosines and v.

use super::{Worst, worst};
use coslobe::integers::CosPower;
use coslobe::{Ball, CosSin, Fixed};
use fixed::types::{I1F31, U16F16};
use kit::integer::reference::{Q31, Q32, Subject, subjects};
use kit::mix;
use std::f64::consts::FRAC_PI_2;

/// |got − want| in the larger of 2⁻¹⁶ and 2⁻²⁸ of the weight.
fn weight_off(got: U16F16, want: f64) -> f64 {
    let want = (want * 65536.0).min(Q32 - 1.0);
    (f64::from(got.to_bits()) - want).abs() / (want / 2f64.powi(28)).max(1.0)
}

/// Every word as a cosine.
fn weight(law: &Subject, x: u32) -> f64 {
    let at = CosSin {
        cos: I1F31::from_bits(x as i32),
        sin: I1F31::ZERO,
    };
    let got = (law.lambert_weight)(at);
    let want = match x as i32 {
        ..0 => return f64::from(got),
        0 if law.k > 1 => return f64::from(U16F16::MAX - got),
        cos => f64::from(cos) / Q31,
    };
    weight_off(got, law.weight_at(want))
}

/// Radii of all magnitudes, cosines and v, corners of each in turn.
fn distance(law: &Subject, index: u32) -> f64 {
    const MOST: i32 = i32::MAX >> 2;
    let (a, b) = (mix(index, 0), mix(index, 1));
    let radius = ((a as u32 >> 3) >> (a >> 32 & 31).min(28)).max(1) as i32;
    let (cos, v) = ((b as u32 >> 1) as i32, (b >> 32) as u32);
    let end = |word: u64| [0, 1, i32::MAX, i32::MAX - 1][(word & 3) as usize];
    let (radius, cos, v) = match a >> 40 & 7 {
        0 | 1 => (MOST, cos, v),
        2 => (MOST, end(b), v),
        3 => (
            radius,
            cos,
            (end(b >> 32) as u32) << 1 | (b >> 34) as u32 & 1,
        ),
        4 => (MOST, cos >> (b >> 33 & 31), v >> (b >> 38 & 31)),
        _ => (radius, cos, v),
    };
    let at = CosSin {
        cos: I1F31::from_bits(cos),
        sin: I1F31::ZERO,
    };
    let (cosine, share) = (f64::from(cos) / Q31, f64::from(v) / Q32);
    let want = law.distance(f64::from(radius), cosine, share);
    (f64::from((law.distance)(radius, at, v)) - want).abs()
}

type Error = fn(&Subject, u32) -> f64;

const ROWS: [(&str, Error); 2] = [("weight", weight), ("distance", distance)];

/// [weight, distance] of each law, in the order of `Id::FIXED`.
const BOUNDS: [[f64; 2]; 6] = [
    [1.1, 1.25],
    [0.0, 0.51],
    [0.51, 0.51],
    [1.75, 1.5],
    [1.1, 0.51],
    [0.0, 0.51],
];

fn hold(strides: [usize; 2]) {
    let mut exceeding = Vec::new();
    for (law, bounds) in subjects().iter().zip(BOUNDS) {
        let name = law.name;
        for (((operation, error), bound), stride) in ROWS.into_iter().zip(bounds).zip(strides) {
            let Worst(error, at) = worst(stride, |x| error(law, x));
            println!("{name} {operation}: {error:.4} at {at:#010x} (bound {bound})");
            if error.is_nan() || error > bound {
                exceeding.push(format!("{name} {operation}: {error} at {at:#010x}"));
            }
        }
    }
    assert!(exceeding.is_empty(), "{exceeding:#?}");
}

#[test]
fn in_strides() {
    hold([1021, 1021]);
}

#[test]
#[ignore = "2³² cosines, 3·10⁸ radii: cargo test --release --test errors q31::weights -- --ignored --nocapture"]
fn weights_exhaustively() {
    hold([1, 13]);
}

/// Another law's, a few units too many where the weight is large, a root that is none.
#[test]
fn wrong_ones_are_caught() {
    let all = subjects();
    let (disk, ball, shell) = (all[0], all[3], all[4]);
    let caught = |law: Subject, row: usize| {
        let Worst(error, _) = worst(1021, |x| ROWS[row].1(&law, x));
        error > 3.0 // more than any bound
    };
    let of_shell = Subject {
        lambert_weight: shell.lambert_weight,
        ..disk
    };
    let more: fn(CosSin<I1F31>) -> U16F16 = |at| {
        let weight = Fixed(Ball).lambert_weight(at);
        weight.saturating_add(weight >> 26)
    };
    let unsaturated: fn(CosSin<I1F31>) -> U16F16 = |at| {
        let weight = Fixed(Ball).lambert_weight(at);
        if weight == U16F16::MAX {
            U16F16::ZERO
        } else {
            weight
        }
    };
    assert!(caught(of_shell, 0));
    assert!(caught(
        Subject {
            lambert_weight: more,
            ..ball
        },
        0
    ));
    assert!(caught(
        Subject {
            lambert_weight: unsaturated,
            ..ball
        },
        0
    ));
    assert!(caught(
        Subject {
            distance: ball.distance,
            ..disk
        },
        1
    ));
    assert!(caught(
        Subject {
            distance: shell.distance,
            ..ball
        },
        1
    ));
}

fn scaled(x: f64) -> I1F31 {
    I1F31::from_bits((x * Q31).round().min(Q31 - 1.0) as i32)
}

/// Of the larger of 2⁻¹⁶ and 2⁻²⁴ of the weight, from the smaller of cos θ and sin θ.
fn power_off(k: f64, law: Fixed<CosPower>, x: u32) -> f64 {
    let (sin, cos) = (f64::from(x) / Q32 * FRAC_PI_2).sin_cos();
    let at = CosSin {
        cos: scaled(cos),
        sin: scaled(sin),
    };
    let [cos, sin] = [at.cos, at.sin].map(|c| f64::from(c.to_bits()) / Q31);
    let ln_cos = if sin < cos {
        (-sin * sin).ln_1p() / 2.0
    } else {
        cos.ln()
    };
    let want = 2.0 / (k + 1.0) * ((1.0 - k) * ln_cos).exp();
    let want = (want * 65536.0).min(Q32 - 1.0);
    let got = f64::from(law.lambert_weight(at).to_bits());
    (got - want).abs() / (want / 2f64.powi(24)).max(1.0)
}

const POWERS: [f64; 9] = [
    0.0,
    1.0 / 65536.0,
    0.5,
    1.0,
    2.0,
    7.25,
    64.0,
    1000.0,
    65536.0 - 1.0 / 65536.0,
];

#[test]
fn of_cos_power() {
    for k in POWERS {
        let law = Fixed(CosPower::new(U16F16::from_num(k)));
        let Worst(error, at) = worst(20011, |x| power_off(k, law, x));
        println!("CosPower({k}) weight: {error:.3} at {at:#010x}");
        assert!(error <= 1.0, "CosPower({k}): {error} at {at:#010x}");
        let rim = CosSin {
            cos: I1F31::ZERO,
            sin: I1F31::MAX,
        };
        let want = if k > 1.0 {
            U16F16::MAX
        } else if k < 1.0 {
            U16F16::ZERO
        } else {
            U16F16::ONE
        };
        assert_eq!(law.lambert_weight(rim), want, "CosPower({k}) at the rim");
    }
}
