//! Every kernel against `f64`, whose error of 10⁻⁶ units is none here: in strides always, and on
//! every input by `cargo test --release --features fixed --lib fixed::q31 -- --ignored --nocapture
//! --test-threads 1`.
extern crate std;

use super::coefficients::{TURN_COS, TURN_SIN};
use super::{angle, cbrt, kepler, recip, sqrt, turn};
use core::f64::consts::{FRAC_PI_2, SQRT_2, TAU};
use rayon::prelude::*;
use std::{println, vec::Vec};

const Q31: f64 = 2147483648.0;
const Q32: f64 = 4294967296.0;

/// Largest error in units of the last place, and its input.
#[derive(Clone, Copy, Debug)]
struct Worst {
    error: f64,
    at: u32,
}

impl Worst {
    fn larger(self, other: Worst) -> Worst {
        if other.error > self.error {
            other
        } else {
            self
        }
    }
}

const NONE: Worst = Worst { error: -1.0, at: 0 };

/// Every `stride`th word, and the 1024 at either side of each of 64 corners.
fn worst(stride: u32, error: impl Fn(u32) -> f64 + Sync) -> Worst {
    let of = |at: u32| Worst {
        error: error(at),
        at,
    };
    let near = (0..64u32)
        .flat_map(|i| (0..2048u32).map(move |j| (i << 26).wrapping_add(j).wrapping_sub(1024)));
    let corners = near.map(of).fold(NONE, Worst::larger);
    let blocks: Vec<u32> = (0..4096).collect();
    let all = blocks
        .par_iter()
        .map(|&b| {
            let from = u64::from(b) << 20;
            let first = from.next_multiple_of(u64::from(stride));
            (first..from + (1 << 20))
                .step_by(stride as usize)
                .map(|x| of(x as u32))
                .fold(NONE, Worst::larger)
        })
        .reduce(|| NONE, Worst::larger);
    all.larger(corners)
}

fn turn_error(phase: u32) -> f64 {
    turn_off(phase, turn::cos_sin(phase))
}

fn turn_off(phase: u32, (cos, sin): (i32, i32)) -> f64 {
    let angle = f64::from(phase as i32) / Q32 * TAU;
    let of = |got: i32, want: f64| (f64::from(got) - want * Q31).abs();
    of(cos, angle.cos()).max(of(sin, angle.sin()))
}

fn unit_error(phase: u32) -> f64 {
    let (cos, sin) = turn::cos_sin(phase);
    (f64::from(cos).hypot(f64::from(sin)) - Q31).abs()
}

fn sqrt_error(x: u32) -> f64 {
    (f64::from(sqrt::sqrt(x)) - (f64::from(x) / Q32).sqrt() * Q31).abs()
}

fn fourth_error(x: u32) -> f64 {
    let (fourth, _) = sqrt::fourth(x);
    (f64::from(fourth) - (f64::from(x) / Q32).sqrt().sqrt() * Q31).abs()
}

fn cbrt_error(x: u32) -> f64 {
    (f64::from(cbrt::cbrt(x)) - (f64::from(x) / Q32).cbrt() * Q32).abs() / 2.0
}

fn recip_error(x: u32) -> f64 {
    let d = x | (1 << 31);
    (f64::from(recip::half_recip(d)) - Q32 * Q32 / 2.0 / f64::from(d)).abs() / 2.0
}

/// √(1 − x²) for x = 1 − v, v of 64 bits from 32 by spreading them over all magnitudes.
fn complement_error(x: u32) -> f64 {
    let v = ((u64::from(x) << 32) | 0x9E37_79B9) >> (x & 31);
    let d = v as f64 / (Q32 * Q32);
    (f64::from(sqrt::complement(v)) - (d * (2.0 - d)).sqrt() * Q31).abs()
}

fn angle_error(phase: u32) -> f64 {
    let at = f64::from(phase >> 2) / Q32;
    let (sin, cos) = (at * TAU).sin_cos();
    let of = |x: f64| (x * Q31).round() as u32;
    (f64::from(angle::first_quadrant(of(cos), of(sin))) - at * Q32).abs()
}

/// Of a pair that is too long, up to (1, 1): near enough to show that nothing wraps.
fn long_angle_error(phase: u32) -> f64 {
    let at = f64::from(phase >> 2) / Q32;
    let (sin, cos) = (at * TAU).sin_cos();
    let of = |x: f64| (x * SQRT_2 * Q31).min(Q31 - 1.0) as u32;
    (f64::from(angle::first_quadrant(of(cos), of(sin))) - at * Q32).abs()
}

/// Against p at the angle found, divided by the slope: no inverse is called for.
fn kepler_error(x: u32) -> f64 {
    let z = cbrt::of_mantissa(x | (1 << 31), 1 + (x & 31));
    let found = f64::from(kepler::from_end(z)) / Q32;
    let y = found * FRAC_PI_2 * 2.0;
    let p = f64::from(x | (1 << 31)) / Q32 / 2f64.powi(1 + (x & 31) as i32);
    // y − sin y = 2πp, by its series where that would cancel.
    let left = if y < 0.5 {
        let s = y * y;
        y * s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0 * (1.0 - s / 110.0))))
    } else {
        y - y.sin()
    };
    ((left - TAU * p) / (1.0 - y.cos()).max(1e-30) / core::f64::consts::PI * Q32).abs()
}

type Row = (&'static str, fn(u32) -> f64, f64);

const ANGLES: [Row; 5] = [
    ("turn", turn_error, 1.5),
    ("unit", unit_error, 2.0),
    ("angle", angle_error, 1.0),
    ("angle of a long pair", long_angle_error, 134217728.0),
    ("kepler", kepler_error, 4.0),
];

const ROOTS: [Row; 5] = [
    ("sqrt", sqrt_error, 1.0),
    ("fourth", fourth_error, 1.0),
    ("cbrt", cbrt_error, 1.0),
    ("recip", recip_error, 4.0),
    ("complement", complement_error, 2.0),
];

/// All rows are measured before one fails.
fn hold(rows: &[Row], stride: u32) {
    let exceeding: Vec<_> = rows
        .iter()
        .filter(|(name, error, bound)| {
            let Worst { error, at } = worst(stride, error);
            println!("{name}: {error:.4} at {at:#010x} (bound {bound})");
            error.is_nan() || error > *bound
        })
        .map(|row| row.0)
        .collect();
    assert!(exceeding.is_empty(), "beyond their bounds: {exceeding:?}");
}

#[test]
fn kernels_in_strides() {
    hold(&ANGLES, 1021);
    hold(&ROOTS, 1021);
}

#[test]
#[ignore = "2³² inputs: cargo test --release --features fixed --lib q31 -- --ignored --nocapture"]
fn angles_exhaustively() {
    hold(&ANGLES, 1);
}

#[test]
#[ignore = "2³² inputs: cargo test --release --features fixed --lib q31 -- --ignored --nocapture"]
fn roots_exhaustively() {
    hold(&ROOTS, 1);
}

/// CMSIS `arm_sin_cos_q31` has the wrong sign in its last interval before −90°.
#[test]
fn a_sign_at_minus_90_degrees_is_caught() {
    let Worst { error, at } = worst(1021, |phase| {
        let (cos, sin) = turn::cos_sin(phase);
        turn_off(
            phase,
            if phase >> 20 == 0xBFF {
                (-cos, sin)
            } else {
                (cos, sin)
            },
        )
    });
    assert!(error > 1e5 && at >> 20 == 0xBFF, "{error} at {at:#010x}");
}

#[test]
fn a_worsened_coefficient_is_caught() {
    let mut spoiled = TURN_SIN;
    spoiled.large[1] += 1 << 6;
    let error = |phase: u32| {
        let (cos, sin) = turn::quarter_by(phase >> 2, &TURN_COS, &spoiled);
        let angle = f64::from(phase >> 2) / Q32 * FRAC_PI_2;
        let of = |got: u32, want: f64| (f64::from(got) - want * Q31).abs();
        of(cos, angle.cos()).max(of(sin, angle.sin()))
    };
    assert!(worst(1021, error).error > 4.0);
}
