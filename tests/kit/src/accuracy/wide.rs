//! Wider arithmetic for the references: `f64` to judge `f32`, double-double to judge `f64` and the
//! doubtful cases of `f32`, double-double with an exponent of its own where those of `f64` run out.
//!
//! Everything that a law needs is built from the standard library, series and Newton steps, not
//! from the crate's kernels; `tests/errors/arb.rs` checks it against the committed Arb tables, and
//! `tests/errors/references.rs` the narrower of it against the wider.

use super::double::Double;
use std::ops::{Add, Div, Mul, Neg, Sub};

pub trait Wide:
    Copy
    + Default
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
{
    /// Relative error that the laws' reference values keep below.
    const EPS: f64;
    /// Terms that sin and cos below 0.9 need, and y − sin y below ½.
    const TERMS: usize;
    const KEPLER_TERMS: usize;
    fn of(x: f64) -> Self;
    fn parts(hi: f64, lo: f64) -> Self;
    /// The nearest `f64`.
    fn near(self) -> f64;
    /// self − x, in `f64`, without cancelling digits away.
    fn minus(self, x: f64) -> f64;
    fn root(self) -> Self;
    fn cube_root(self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    /// ln(1 − x), 0 ≤ x ≤ 3/4.
    fn ln_one_minus(self) -> Self;
    /// 1 − e⁻ˣ, x ≥ 0.
    fn one_minus_exp_neg(self) -> Self;
    /// (sin x, cos x), 0 ≤ x ≤ 1.6.
    fn sin_cos(self) -> (Self, Self);
    /// π/2 − a for a in [0, π/2], with a third word of π/2.
    fn from_end(a: f64) -> Self;
    /// 1/n!
    fn inverse_factorial(n: usize) -> Self;
    /// η of Kepler's equation (2η − sin 2η)/2π = p for 0 < p < 0.15.
    fn kepler(p: f64) -> Self;
    /// self·2ⁿ as a double-double.
    fn lifted(self, n: i32) -> Double;

    fn pi() -> Self {
        Self::parts(std::f64::consts::PI, 1.2246467991473532e-16)
    }

    /// Angle of a unit vector with cos, sin ≥ 0: `f64`'s, corrected by sin(θ − θ₀).
    fn angle(cos: Self, sin: Self) -> Self {
        let guess = Self::of(sin.near().atan2(cos.near()));
        let (s, c) = guess.sin_cos();
        guess + (sin * c - cos * s)
    }
}

pub const HALF_PI: [f64; 3] = [
    std::f64::consts::FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591833e-33,
];

impl Wide for f64 {
    const EPS: f64 = 1e-12;
    const TERMS: usize = 10;
    const KEPLER_TERMS: usize = 8;
    fn of(x: f64) -> f64 {
        x
    }
    fn parts(hi: f64, _: f64) -> f64 {
        hi
    }
    fn near(self) -> f64 {
        self
    }
    fn minus(self, x: f64) -> f64 {
        self - x
    }
    fn root(self) -> f64 {
        self.sqrt()
    }
    fn cube_root(self) -> f64 {
        self.cbrt()
    }
    fn exp(self) -> f64 {
        f64::exp(self)
    }
    fn ln(self) -> f64 {
        f64::ln(self)
    }
    fn ln_one_minus(self) -> f64 {
        (-self).ln_1p()
    }
    fn one_minus_exp_neg(self) -> f64 {
        -(-self).exp_m1()
    }
    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }
    fn from_end(a: f64) -> f64 {
        HALF_PI[0] - a + HALF_PI[1]
    }
    fn angle(cos: f64, sin: f64) -> f64 {
        sin.atan2(cos)
    }
    fn inverse_factorial(n: usize) -> f64 {
        INVERSE_FACTORIALS[n]
    }
    fn kepler(p: f64) -> f64 {
        let s = (12.0 * std::f64::consts::PI * p).cbrt();
        let t = s * s;
        let start = s * 0.5 * KEPLER_START.iter().rev().fold(0.0, |sum, c| sum * t + c);
        // The series alone is exact where its first terms left out vanish.
        if t < 0.2 {
            return start;
        }
        let (sin, cos) = start.sin_cos();
        start - (kepler_tail(start, sin, cos) - p) * std::f64::consts::FRAC_PI_2 / (sin * sin)
    }
    fn lifted(self, n: i32) -> Double {
        Double::from(self).scale(n)
    }
}

/// y/s in powers of s², for y − sin y = s³/6.
const KEPLER_START: [f64; 13] = [
    1.0,
    1.0 / 60.0,
    1.0 / 1400.0,
    1.0 / 25200.0,
    43.0 / 17248000.0,
    1.683039183039183e-7,
    1.1911667949082915e-8,
    8.716860870222215e-10,
    6.539638581589419e-11,
    5.001592370976041e-12,
    3.8844043825273724e-13,
    3.054732998294483e-14,
    2.4273770483331233e-15,
];

const INVERSE_FACTORIALS: [f64; 32] = {
    let mut all = [1.0; 32];
    let (mut n, mut factorial) = (1, 1.0);
    while n < 32 {
        factorial *= n as f64;
        all[n] = 1.0 / factorial;
        n += 1;
    }
    all
};

/// Σ over i < n of (−1)ⁱ tⁱ/(2i + first)!
pub fn alternating<W: Wide>(t: W, first: usize, n: usize) -> W {
    (0..n).rev().fold(W::default(), |sum, i| {
        W::inverse_factorial(2 * i + first) - sum * t
    })
}

/// (2η − sin 2η)/2π, given sin η and cos η.
pub fn kepler_tail<W: Wide>(eta: W, sin: W, cos: W) -> W {
    if eta.near() > 0.25 {
        return (eta - sin * cos) / W::pi();
    }
    let y = eta + eta;
    let t = y * y;
    y * t * alternating(t, 3, W::KEPLER_TERMS) / (W::pi() * W::of(2.0))
}
