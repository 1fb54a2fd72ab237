//! Every kernel against an f64 reference: one table of bounds.
//!
//! `cargo test fast` walks each domain in strides; `cargo test --release fast -- --ignored
//! --nocapture` takes every `f32` of the part of it where the error has its full period, and
//! prints the worst.
extern crate std;

mod reference;
mod special;
mod ways;

use super::tail_root::TailRoot;
use super::{angle, coefficients, fixed, kepler, power, root, uniform};
use crate::Tails;
use crate::arithmetic::native::f32::power_of_two;
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use reference::{cos, end, eta, ln_cos, sin, sin_turn, tail};
use std::{println, vec::Vec};

/// Every float of the domain has a relative error below 2^bound; `dense` is the part taken whole.
struct Row {
    name: &'static str,
    bound: f64,
    domain: (f32, f32),
    dense: (f32, f32),
    kernel: fn(f32) -> f32,
    reference: fn(f64) -> f64,
}

const fn row(
    name: &'static str,
    bound: f64,
    domain: (f32, f32),
    dense: (f32, f32),
    kernel: fn(f32) -> f32,
    reference: fn(f64) -> f64,
) -> Row {
    Row {
        name,
        bound,
        domain,
        dense,
        kernel,
        reference,
    }
}

const END: f32 = f32::from_bits(core::f32::consts::FRAC_PI_2.to_bits() - 1);
const HALF_DOWN: f32 = f32::from_bits(0.5f32.to_bits() - 1);
const TINY: f32 = f32::MIN_POSITIVE;
const LEAST: f32 = f32::from_bits(1);
const MAX: f32 = f32::MAX;
const LARGE: f32 = power_of_two(100);

fn exp(x: f32) -> f32 {
    power::exp_times(x, 1.0)
}

/// (cos θ, sin θ) with cosⁿθ = 1 − p.
fn power_warp(n: f32, p: f32) -> (f32, f32) {
    TailRoot::new(n).at(Tails::from_lower(p))
}

// One line a row, so that it reads as the table it is.
#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("cbrt, subnormal", -14.7, (LEAST, TINY), (LEAST, TINY), root::cbrt, libm::cbrt),
    row("ln, subnormal", -21.4, (LEAST, TINY), (LEAST, TINY), power::ln, libm::log),
    row("cbrt", -14.7, (TINY, LARGE), (1.0, 8.0), root::cbrt, libm::cbrt),
    row("sin_cos: cos", -19.7, (TINY, END), (0.01, END), |x| angle::sin_cos(x).0, libm::cos),
    row("sin_cos: sin", -13.1, (TINY, END), (0.01, END), |x| angle::sin_cos(-x).1, libm::sin),
    row("turn: cos", -12.8, (TINY, 1.0), (1e-3, 1.0), |u| angle::turn(u).0,
        |u| sin_turn(u + 0.25)),
    row("turn: sin", -13.0, (2.0 * TINY, 1.0), (1e-3, 1.0), |u| angle::turn(u).1, sin_turn),
    row("half_turn: cos", -13.1, (TINY, 0.5), (1e-3, 0.5),
        |p| angle::half_turn(p).0, |p| libm::sin(PI * p)),
    row("half_turn: sin", -13.1, (TINY, HALF_DOWN), (1e-3, HALF_DOWN),
        |p| angle::half_turn(p).1, |p| libm::sin(PI * (0.5 - p))),
    row("atan2: flat", -15.0, (TINY, 1.0), (1e-3, 1.0), |t| angle::atan2_first(t, 1.0), libm::atan),
    row("atan2: steep", -15.0, (TINY, 1.0), (1e-3, 1.0),
        |t| angle::atan2(1.0, t), |t| libm::atan2(1.0, t)),
    row("atan2: steep, behind", -16.5, (TINY, 1.0), (1e-3, 1.0),
        |t| angle::atan2(1.0, -t), |t| libm::atan2(1.0, -t)),
    row("atan2: flat, behind", -16.5, (TINY, 1.0), (1e-3, 1.0),
        |t| angle::atan2(-t, -1.0), |t| libm::atan2(-t, -1.0)),
    row("ln", -21.4, (TINY, MAX), (0.25, 4.0), power::ln, libm::log),
    row("tail_root: cos", -15.3, (TINY, 0.99), (1e-3, 0.99), |p| power_warp(20.0, p).0,
        |p| libm::exp(libm::log1p(-p) / 20.0)),
    row("tail_root: sin", -15.0, (LEAST, 0.99), (1e-3, 0.99), |p| power_warp(20.0, p).1,
        |p| libm::sqrt(-libm::expm1(libm::log1p(-p) / 10.0))),
    row("tail_root: huge n", -15.4, (LEAST, 0.99), (1e-3, 0.99), |p| power_warp(MAX, p).1,
        |p| libm::sqrt(-2.0 * libm::log1p(-p) / f64::from(MAX))),
    row("fourth_power_warp: sin", -13.9, (LEAST, 1.0), (1e-3, 1.0),
        |p| root::fourth_power_warp(p, 1.0 - p).1,
        |p| libm::sqrt(p / (1.0 + libm::sqrt(1.0 - p)))),
    row("ln_cos", -20.7, (2e-19, END), (0.01, END), |x| power::ln_cos(cos(x), sin(x)), ln_cos),
    row("cos to the 100th", -14.7, (1e-6, 1.1), (1e-3, 1.1),
        |x| exp(100.0 * power::ln_cos(cos(x), sin(x))), |x| libm::exp(100.0 * ln_cos(x))),
    row("exp, x < 0", -15.1, (TINY, 87.3), (1e-3, 87.3), |x| exp(-x), |x| libm::exp(-x)),
    row("exp, x > 0", -15.1, (TINY, 88.7), (1e-3, 88.7), exp, libm::exp),
    row("one_minus_exp", -13.8, (TINY, MAX), (1e-3, 32.0),
        |x| power::one_minus_exp(-x), |x| -libm::expm1(-x)),
    row("tail_at_angle", -16.2, (TINY, END), (0.01, END), kepler::tail_at_angle, |x| tail(end(x))),
    row("tail_at_direction", -13.2, (TINY, END), (0.01, END),
        |x| kepler::tail_at_direction(cos(x), sin(x)), |x| tail(end(x))),
    row("direction_at_tail: cos", -14.0, (TINY, 0.5), (1e-3, 0.5),
        |p| kepler::direction_at_tail(p).0, |p| libm::sin(eta(p))),
    row("direction_at_tail: sin", -13.5, (TINY, HALF_DOWN), (1e-3, HALF_DOWN),
        |p| kepler::direction_at_tail(p).1, |p| libm::cos(eta(p))),
    row("angle_at_tail", -14.2, (TINY, HALF_DOWN), (1e-3, HALF_DOWN),
        kepler::angle_at_tail, |p| FRAC_PI_2 - eta(p)),
];

/// log₂ of the worst relative error, and where.
fn worst(row: &Row, (from, to): (f32, f32), stride: usize) -> (f64, f32) {
    let inner = (from.to_bits()..=to.to_bits()).step_by(stride);
    let mut worst = (0.0, 0.0);
    for x in inner.map(f32::from_bits).chain([to]) {
        let reference = (row.reference)(f64::from(x));
        // What is subnormal as an f32 has fewer digits.
        if reference.abs() < f64::from(TINY) {
            continue;
        }
        let error = (f64::from((row.kernel)(x)) / reference - 1.0).abs();
        if error.is_nan() {
            return (f64::NAN, x);
        }
        if error > worst.0 {
            worst = (error, x);
        }
    }
    (libm::log2(worst.0), worst.1)
}

fn check(part: fn(&Row) -> (f32, f32), stride: usize) {
    let mut failures = Vec::new();
    for row in ROWS {
        let (error, at) = worst(row, part(row), stride);
        let (name, bound, at) = (row.name, row.bound, at.to_bits());
        println!("{name:21} 2^{error:.2}, bound 2^{bound:.1}, at {at:#010x}");
        if error.is_nan() || error > bound {
            failures.push(name);
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

#[test]
fn errors_in_strides() {
    check(|row| row.domain, 1021);
    check(|row| row.dense, 127);
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release fast -- --ignored --nocapture"]
fn errors_at_every_float() {
    check(|row| row.dense, 1);
}

/// Worst relative error of `kernel` over the words 0, stride, 2·stride, ….
fn worst_turn(stride: usize) -> f64 {
    let error = |bits: u32| {
        let turns = (f64::from(bits) + 0.5) / 4294967296.0;
        let (cos, sin) = uniform::turn(bits);
        let of = |got: f32, want: f64| (f64::from(got) / want - 1.0).abs();
        of(cos, libm::cos(TAU * turns)).max(of(sin, libm::sin(TAU * turns)))
    };
    let axes =
        (0..4u32).flat_map(|q| (0..4).map(move |i| (q << 30).wrapping_add(i).wrapping_sub(2)));
    libm::log2(
        (0..=u32::MAX)
            .step_by(stride)
            .chain(axes)
            .map(error)
            .fold(0.0, f64::max),
    )
}

#[test]
fn turns() {
    let error = worst_turn(1021);
    assert!(error < -14.0, "2^{error:.2}");
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release fast -- --ignored --nocapture"]
fn turns_of_every_word() {
    let error = worst_turn(1);
    println!("turn: 2^{error:.2}");
    assert!(error < -14.0);
}

#[test]
fn tails() {
    let rounded = |odd: f64| (odd / 4294967296.0) as f32;
    let edges = [127, 128, 129, 1 << 31, (1 << 31) - 1];
    for n in (0..=u32::MAX)
        .step_by(1021)
        .chain(edges)
        .flat_map(|n| [n, !n])
    {
        let odd = f64::from(n | 1);
        let both = [odd, 4294967296.0 - odd].map(rounded);
        assert_eq!(uniform::tails_by::<true>(n), both, "{n:#x}");
        assert_eq!(uniform::tails_by::<false>(n), both, "{n:#x}");
        let (p, is_upper) = uniform::tail(n);
        assert_eq!(p, rounded(f64::from(n & !(1 << 31) | 1)), "{n:#x}");
        assert_eq!(is_upper, n >= 1 << 31, "{n:#x}");
        assert!(p > 0.0 && p <= 0.5, "{n:#x}");
    }
}

/// A coefficient off by 2⁻¹⁰ of itself is an error that the bounds notice.
#[test]
fn planted_errors_are_seen() {
    let off = 1.0 + 1.0 / 1024.0;
    let bound = |name| {
        ROWS.iter()
            .find(|row| row.name == name)
            .map(|row| row.bound)
    };
    let mut sin = coefficients::SIN;
    for (i, at) in [(0, 1.0f32), (1, 1.5)] {
        sin[i] *= off;
        let got = f64::from(at * fixed::horner(at * at, &sin));
        let error = libm::log2((got / libm::sin(f64::from(at)) - 1.0).abs());
        assert!(Some(error) > bound("sin_cos: sin"), "{error}");
        sin = coefficients::SIN;
    }
    let mut root = coefficients::CBRT;
    root.inner[0] = (f64::from(root.inner[0]) * f64::from(off)) as i32;
    let got = 1.0 + f64::from(root.at(1 << 15) as i32) / 4294967296.0;
    let error = libm::log2((got / libm::cbrt(0.5) - 1.0).abs());
    assert!(Some(error) > bound("cbrt"), "{error}");
}
