//! Wider arithmetic for the references: `f64` to judge `f32`, double-double to judge `f64`.
//!
//! Everything that a law needs is built here from series and Newton steps, not from the crate's
//! kernels; `tests/error_bounds.rs` first checks it against the committed Arb tables.

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
    /// Relative error that its functions keep below.
    const EPS: f64;
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

const HALF_PI: [f64; 3] = [
    std::f64::consts::FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591833e-33,
];

impl Wide for f64 {
    const EPS: f64 = 1e-12;
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
}

fn two(x: f64) -> Double {
    Double::from(x)
}

/// Σ over terms given by `next(term, i)` from `first` until they no longer count.
fn series(first: Double, next: impl Fn(Double, i32) -> Double) -> Double {
    let (mut sum, mut term) = (first, first);
    for i in 1..200 {
        term = next(term, i);
        sum = sum + term;
        if term.hi.abs() <= sum.hi.abs() * 1e-34 {
            break;
        }
    }
    sum
}

/// eʳ − 1 for |r| ≤ 1/2.
fn small_exp_m1(r: Double) -> Double {
    series(r, |t, i| t * r / two(f64::from(i + 1)))
}

const LN_2: [f64; 2] = [std::f64::consts::LN_2, 2.3190468138462996e-17];

impl Wide for Double {
    const EPS: f64 = 1e-29;
    fn of(x: f64) -> Self {
        two(x)
    }
    fn parts(hi: f64, lo: f64) -> Self {
        Double::sum(hi, lo)
    }
    fn near(self) -> f64 {
        self.hi
    }
    fn minus(self, x: f64) -> f64 {
        (self.hi - x) + self.lo
    }
    fn root(self) -> Self {
        if self.hi <= 0.0 {
            return two(0.0);
        }
        // Scaled by an even power, so that no residual underflows.
        let n = (self.hi.log2() / 2.0) as i32;
        let x = self.scale(-2 * n);
        let guess = two(x.hi.sqrt());
        (guess + (x - guess * guess) / (guess * two(2.0))).scale(n)
    }
    fn cube_root(self) -> Self {
        if self.hi <= 0.0 {
            return two(0.0);
        }
        let n = (self.hi.log2() / 3.0) as i32;
        let x = self.scale(-3 * n);
        let guess = two(x.hi.cbrt());
        (guess + (x - guess * guess * guess) / (guess * guess * two(3.0))).scale(n)
    }
    fn exp(self) -> Self {
        let n = (self.hi / LN_2[0]).round();
        if n < -2500.0 {
            return two(0.0);
        }
        let r = self - Double::product(n, LN_2[0]) - Double::product(n, LN_2[1]);
        (two(1.0) + small_exp_m1(r)).scale(n as i32)
    }
    fn ln(self) -> Self {
        if self.hi <= 0.0 {
            return two(f64::NEG_INFINITY);
        }
        let n = self.hi.log2().round() as i32;
        let m = self.scale(-n);
        // ln m = 2 atanh((m − 1)/(m + 1)).
        let z = (m - two(1.0)) / (m + two(1.0));
        let n = f64::from(n);
        double_atanh(z) + Double::product(n, LN_2[0]) + Double::product(n, LN_2[1])
    }
    fn ln_one_minus(self) -> Self {
        if self.hi < 1e-40 {
            return -self;
        }
        if self.hi > 0.25 {
            return Wide::ln(two(1.0) - self);
        }
        double_atanh(-self / (two(2.0) - self))
    }
    fn one_minus_exp_neg(self) -> Self {
        if self.hi > 0.5 {
            return two(1.0) - Wide::exp(-self);
        }
        if self.hi < 1e-40 {
            return self;
        }
        -small_exp_m1(-self)
    }
    fn sin_cos(self) -> (Self, Self) {
        if self.hi > 0.9 {
            let (s, c) = (Self::parts(HALF_PI[0], HALF_PI[1]) - self).sin_cos_small();
            return (c, s);
        }
        self.sin_cos_small()
    }
    fn from_end(a: f64) -> Self {
        let d = Double::sum(HALF_PI[0], -a);
        d + Double::sum(HALF_PI[1], HALF_PI[2])
    }
}

trait SinCosSmall: Sized {
    fn sin_cos_small(self) -> (Self, Self);
}

impl SinCosSmall for Double {
    fn sin_cos_small(self) -> (Self, Self) {
        let square = self * self;
        let step = |first: f64| {
            move |t: Double, i: i32| {
                let n = first + 2.0 * f64::from(i);
                -(t * square) / two(n * (n - 1.0))
            }
        };
        (series(self, step(1.0)), series(two(1.0), step(0.0)))
    }
}

/// 2 atanh z = ln((1 + z)/(1 − z)).
fn double_atanh(z: Double) -> Double {
    let square = z * z;
    let mut power = z;
    let mut sum = z;
    for i in 1..400 {
        power = power * square;
        let term = power / two(f64::from(2 * i + 1));
        sum = sum + term;
        if term.hi.abs() <= sum.hi.abs() * 1e-34 {
            break;
        }
    }
    sum * two(2.0)
}
