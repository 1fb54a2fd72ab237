//! Every kernel against `f64`: those of an angle on all 2¹⁶ phases, roots on all 2¹⁶ half-words
//! and on 2²² words of all magnitudes. Errors are in units of 2⁻¹⁵ (of 2⁻¹⁶ for angles and
//! reciprocals), before the last rounding but for the first two.
extern crate std;

use super::coefficients::{TURN_COS, TURN_SIN};
use super::{Q15 as Format15, angle, draw, kepler, root, turn};
use crate::integers::{Format, cos_sin};
use ::fixed::types::{I0F16, I1F15};
use core::f64::consts::{FRAC_PI_4, SQRT_2, TAU};
use std::{println, vec::Vec};

const Q15: f64 = 32768.0;
const Q16: f64 = 65536.0;
const Q31: f64 = 2147483648.0;
const Q32: f64 = 4294967296.0;

/// Largest error and its input.
fn worst(inputs: impl Iterator<Item = u32>, error: impl Fn(u32) -> f64) -> (f64, u32) {
    inputs.map(|x| (error(x), x)).fold((-1.0, 0), |a, b| {
        // Written so that NaN stays.
        if a.0 >= b.0 { a } else { b }
    })
}

/// All half-words, then words of all magnitudes.
fn words() -> impl Iterator<Item = u32> {
    let scattered = (1..1u32 << 22).map(|i| i.wrapping_mul(0x9E37_79B9) >> (i & 31));
    (0..1 << 16).map(|x| x << 16).chain(scattered)
}

/// Those that are 0 or have a bit in the upper half.
fn long(x: u32) -> u32 {
    if x >> 16 == 0 { x << 16 } else { x }
}

fn turn_off(phase: u32, (cos, sin): (i16, i16)) -> f64 {
    let (s, c) = (f64::from(phase as i16) / Q16 * TAU).sin_cos();
    let of = |got: i16, want: f64| (f64::from(got) - want * Q15).abs();
    of(cos, c).max(of(sin, s))
}

fn found(phase: u32) -> (i16, i16) {
    let at = cos_sin(I0F16::from_bits(phase as i16));
    (at.cos.to_bits(), at.sin.to_bits())
}

fn turn_error(phase: u32) -> f64 {
    turn_off(phase, found(phase))
}

fn unit_error(phase: u32) -> f64 {
    let (cos, sin) = found(phase);
    (f64::from(cos).hypot(f64::from(sin)) - Q15).abs()
}

fn angle_error(phase: u32) -> f64 {
    let at = f64::from(phase) / Q16 / 4.0;
    let (sin, cos) = (at * TAU).sin_cos();
    let of = |x: f64| (x * Q31).round() as u32;
    (f64::from(angle::first_quadrant(of(cos), of(sin))) / Q16 - at * Q16).abs()
}

/// Of a pair that is too long, up to (1, 1): near enough to show that nothing wraps.
fn long_angle_error(phase: u32) -> f64 {
    let at = f64::from(phase) / Q16 / 4.0;
    let (sin, cos) = (at * TAU).sin_cos();
    let of = |x: f64| (x * SQRT_2 * Q31).min(Q31 - 1.0) as u32;
    (f64::from(angle::first_quadrant(of(cos), of(sin))) / Q16 - at * Q16).abs()
}

fn sqrt_error(x: u32) -> f64 {
    if x == 0 {
        return 0.0;
    }
    (f64::from(root::scaled::<32>(x, 0)) / Q32 - (f64::from(x) / Q32).sqrt()).abs() * Q15
}

fn fourth_error(x: u32) -> f64 {
    let x = long(x);
    let (fourth, _) = root::fourth(x);
    (f64::from(fourth) / Q31 - (f64::from(x) / Q32).sqrt().sqrt()).abs() * Q15
}

fn cbrt_error(x: u32) -> f64 {
    let x = long(x);
    (f64::from(root::cbrt(x)) / Q32 - (f64::from(x) / Q32).cbrt()).abs() * Q15
}

fn recip_error(x: u32) -> f64 {
    let d = x | (1 << 31);
    (f64::from(root::half_recip(d)) / Q32 - Q32 / 2.0 / f64::from(d)).abs() * Q16
}

/// √(1 − x²) for x = 1 − v.
fn complement_error(v: u32) -> f64 {
    let d = f64::from(v) / Q32;
    (f64::from(root::complement::<32>(v)) / Q31 - (d * (2.0 - d)).sqrt()).abs() * Q15
}

/// Against p at the angle found, divided by the slope: no inverse is called for.
fn kepler_error(z: u32) -> f64 {
    let z = (z >> 16 << 16).min(3408917802);
    let p = (f64::from(z) / Q32).powi(3);
    let y = f64::from(kepler::from_end(z)) / Q32 * core::f64::consts::PI;
    let s = y * y;
    let left = if y < 0.5 {
        y * s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0 * (1.0 - s / 72.0)))
    } else {
        y - y.sin()
    };
    ((left - TAU * p) / (1.0 - y.cos()).max(1e-9) / core::f64::consts::PI).abs() * Q16
}

type Row = (&'static str, fn(u32) -> f64, f64);

const PHASES: [Row; 4] = [
    ("turn", turn_error, 1.0),
    ("unit", unit_error, 1.0),
    ("angle", angle_error, 0.56),
    ("angle of a long pair", long_angle_error, 2048.0),
];

const ROOTS: [Row; 6] = [
    ("sqrt", sqrt_error, 0.4),
    ("fourth", fourth_error, 0.57),
    ("cbrt", cbrt_error, 0.47),
    ("recip", recip_error, 3.23),
    ("complement", complement_error, 0.39),
    ("kepler", kepler_error, 1.01),
];

#[test]
fn kernels_on_every_half_word() {
    let all = PHASES
        .iter()
        .map(|row| (row, worst(0..1 << 16, row.1)))
        .chain(ROOTS.iter().map(|row| (row, worst(words(), row.1))));
    let exceeding: Vec<_> = all
        .filter(|((name, _, bound), (error, at))| {
            println!("{name}: {error:.4} at {at:#x} (bound {bound})");
            error.is_nan() || error > bound
        })
        .map(|(row, _)| row.0)
        .collect();
    assert!(exceeding.is_empty(), "beyond their bounds: {exceeding:?}");
}

/// CMSIS `arm_sin_cos_q31` has the wrong sign in its last interval before −90°.
#[test]
fn a_sign_at_minus_90_degrees_is_caught() {
    let (error, at) = worst(0..1 << 16, |phase| {
        let (cos, sin) = found(phase);
        let cos = if phase == 0xBFFF { -cos } else { cos };
        turn_off(phase, (cos, sin))
    });
    assert!(error > 5.0 && at == 0xBFFF, "{error} at {at:#x}");
}

#[test]
fn a_worsened_coefficient_is_caught() {
    let mut spoiled = TURN_SIN;
    spoiled.small[1] += 16;
    let (error, at) = worst(0..1 << 16, |y| {
        let (cos, sin) = turn::eighth_by(y, &TURN_COS, &spoiled);
        let (s, c) = (f64::from(y) / Q16 * FRAC_PI_4).sin_cos();
        let of = |got: u32, want: f64| (f64::from(got) / Q31 - want).abs() * Q15;
        of(cos, c).max(of(sin, s))
    });
    assert!(error > 2.0, "{error} at {at:#x}");
}

/// The sine of a sample beside the horizon saturates: rounded up it would be −1.
#[test]
fn the_sine_beside_the_horizon_is_positive() {
    for cos in (0..1 << 20).step_by(997) {
        let drawn = draw::spatial(cos, 0);
        let sin = Format15::component(drawn.at.sin);
        assert!(sin >= I1F15::from_bits(32000), "{sin} of cos θ = {cos}");
    }
}
