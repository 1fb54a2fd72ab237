//! f64 references of the disk's law and of ln cos.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

pub(super) fn cos(x: f32) -> f32 {
    libm::cos(f64::from(x)) as f32
}

pub(super) fn sin(x: f32) -> f32 {
    libm::sin(f64::from(x)) as f32
}

/// sin 2πu for 0 ≤ u ≤ 1¼, relatively accurate about its zeros.
pub(super) fn sin_turn(u: f64) -> f64 {
    match u {
        ..=0.25 => libm::sin(TAU * u),
        ..=0.75 => -libm::sin(TAU * (u - 0.5)),
        _ => libm::sin(TAU * (u - 1.0)),
    }
}

pub(super) fn end(x: f64) -> f64 {
    (FRAC_PI_2 - x) + 6.123233995736766e-17
}

pub(super) fn ln_cos(x: f64) -> f64 {
    let s = libm::sin(x);
    if s < 0.5 {
        0.5 * libm::log1p(-s * s)
    } else {
        libm::log(libm::cos(x))
    }
}

/// y − sin y.
fn kepler_part(y: f64) -> f64 {
    let v = y * y;
    if y > 1.0 {
        y - libm::sin(y)
    } else {
        let series = [20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0];
        y * v / 6.0 * series.iter().rev().fold(1.0, |sum, k| 1.0 - v / k * sum)
    }
}

/// The disk's tail at η from its end.
pub(super) fn tail(eta: f64) -> f64 {
    kepler_part(2.0 * eta) / TAU
}

/// Its inverse, by Newton from the leading term of the series.
pub(super) fn eta(p: f64) -> f64 {
    let s = libm::cbrt(12.0 * PI * p);
    let mut y = s * (1.0 + s * s * (1.0 / 60.0 + s * s / 1400.0));
    for _ in 0..3 {
        let half = libm::sin(y / 2.0);
        y -= (kepler_part(y) - TAU * p) / (2.0 * half * half);
    }
    y / 2.0
}
