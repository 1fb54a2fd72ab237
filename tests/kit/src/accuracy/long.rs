//! Double-double with an exponent of its own: no value of a law under- or overflows in it, so that
//! it judges subnormal results, and results of subnormal arguments, as it does all others.

use super::double::Double;
use super::wide::Wide;
use super::wide_double::{LN_2, exp_parts, ln_near_one};
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// m·2ᵉ with 1 ≤ |m| < 2, or m = 0, infinite or NaN.
#[derive(Clone, Copy, Debug, Default)]
pub struct Long {
    m: Double,
    e: i32,
}

impl Long {
    fn new(m: Double, e: i32) -> Self {
        if m.hi == 0.0 || !m.hi.is_finite() {
            return Long { m, e: 0 };
        }
        let n = exponent(m.hi);
        Long {
            m: m.scale(-n),
            e: e + n,
        }
    }

    /// As a double-double: exact from 2⁻⁹⁰⁰ to 2¹⁰⁰⁰.
    fn double(self) -> Double {
        self.lifted(0)
    }

    /// A function of the double-double, for arguments within its range.
    fn of_double(x: Double) -> Self {
        Self::new(x, 0)
    }
}

fn exponent(x: f64) -> i32 {
    let field = |x: f64| ((x.to_bits() >> 52) & 0x7FF) as i32 - 1023;
    if x.abs() < f64::MIN_POSITIVE {
        field(x * 2f64.powi(100)) - 100
    } else {
        field(x)
    }
}

impl From<f64> for Long {
    fn from(x: f64) -> Self {
        Self::new(x.into(), 0)
    }
}

impl Add for Long {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        let (large, small) = if b.m.hi == 0.0 || (self.m.hi != 0.0 && self.e >= b.e) {
            (self, b)
        } else {
            (b, self)
        };
        let gap = small.e - large.e;
        if small.m.hi == 0.0 || gap < -220 {
            return large;
        }
        Self::new(large.m + small.m.scale(gap), large.e)
    }
}

impl Neg for Long {
    type Output = Self;
    fn neg(self) -> Self {
        Long {
            m: -self.m,
            e: self.e,
        }
    }
}

impl Sub for Long {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Long {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self::new(self.m * b.m, self.e + b.e)
    }
}

impl Div for Long {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        Self::new(self.m / b.m, self.e - b.e)
    }
}

impl PartialEq for Long {
    fn eq(&self, b: &Self) -> bool {
        self.partial_cmp(b) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Long {
    fn partial_cmp(&self, b: &Self) -> Option<Ordering> {
        (*self - *b).m.hi.partial_cmp(&0.0)
    }
}

impl Wide for Long {
    const EPS: f64 = Double::EPS;
    const TERMS: usize = Double::TERMS;
    const KEPLER_TERMS: usize = Double::KEPLER_TERMS;
    fn of(x: f64) -> Self {
        x.into()
    }
    fn parts(hi: f64, lo: f64) -> Self {
        Long::from(hi) + Long::from(lo)
    }
    fn near(self) -> f64 {
        self.double().hi
    }
    fn minus(self, x: f64) -> f64 {
        (self - x.into()).near()
    }
    fn root(self) -> Self {
        let odd = self.e.rem_euclid(2);
        Self::new(self.m.scale(odd).root(), (self.e - odd) / 2)
    }
    fn cube_root(self) -> Self {
        let rest = self.e.rem_euclid(3);
        Self::new(self.m.scale(rest).cube_root(), (self.e - rest) / 3)
    }
    fn exp(self) -> Self {
        if self.near().abs() > 1e6 {
            return Long::from(if self.m.hi > 0.0 { f64::INFINITY } else { 0.0 });
        }
        let (n, power) = exp_parts(self.double());
        Self::new(power, n as i32)
    }
    fn ln(self) -> Self {
        if self.m.hi <= 0.0 {
            return Long::from(f64::NEG_INFINITY);
        }
        let half = i32::from(self.m.hi > 1.4);
        let (n, m) = (f64::from(self.e + half), self.m.scale(-half));
        let whole = Double::product(n, LN_2[0]) + Double::product(n, LN_2[1]);
        Self::of_double(ln_near_one(m) + whole)
    }
    fn ln_one_minus(self) -> Self {
        if self.e < -130 {
            return -self;
        }
        Self::of_double(self.double().ln_one_minus())
    }
    fn one_minus_exp_neg(self) -> Self {
        if self.e < -130 {
            return self;
        }
        if self.near() > 1e6 {
            return Long::from(1.0);
        }
        Self::of_double(self.double().one_minus_exp_neg())
    }
    fn sin_cos(self) -> (Self, Self) {
        if self.e < -60 {
            return (self, Long::from(1.0));
        }
        let (s, c) = self.double().sin_cos();
        (Self::of_double(s), Self::of_double(c))
    }
    fn from_end(a: f64) -> Self {
        Self::of_double(Double::from_end(a))
    }
    fn inverse_factorial(n: usize) -> Self {
        Self::of_double(Double::inverse_factorial(n))
    }
    fn kepler(p: f64) -> Self {
        if p > 1e-60 {
            return Self::of_double(Double::kepler(p));
        }
        (Long::pi() * Long::from(12.0) * Long::from(p)).cube_root() * Long::from(0.5)
    }
    fn lifted(self, n: i32) -> Double {
        self.m.scale(self.e + n)
    }
}
