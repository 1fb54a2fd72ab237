//! Double-double arithmetic (Dekker, Knuth): about 2⁻¹⁰⁴ relative.
//!
//! Its own sixty lines, since the published crate tried first (twofloat 0.8.4) divides to
//! single precision: its 1/3 has no low word. The Arb tables judge this one.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Double {
    pub hi: f64,
    pub lo: f64,
}

impl Double {
    pub fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let part = hi - a;
        Double {
            hi,
            lo: (a - (hi - part)) + (b - part),
        }
    }

    pub fn product(a: f64, b: f64) -> Self {
        let split = |x: f64| {
            let high = f64::from_bits(x.to_bits() & !0x7FF_FFFF);
            (high, x - high)
        };
        let (hi, (ah, al), (bh, bl)) = (a * b, split(a), split(b));
        Double {
            hi,
            lo: (((ah * bh - hi) + ah * bl) + al * bh) + al * bl,
        }
    }

    /// 2ⁿ·self; rounds only where it underflows.
    pub fn scale(self, n: i32) -> Self {
        // Beyond this all is 0 or infinite.
        let n = n.clamp(-2000, 2000);
        let half = n / 2;
        let power = |n: i32| f64::from_bits(((n + 1023) as u64) << 52);
        let (a, b) = (power(half), power(n - half));
        Double {
            hi: self.hi * a * b,
            lo: self.lo * a * b,
        }
    }
}

impl From<f64> for Double {
    fn from(hi: f64) -> Self {
        Double { hi, lo: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        let (high, low) = (Self::sum(self.hi, b.hi), Self::sum(self.lo, b.lo));
        let s = Self::sum(high.hi, high.lo + low.hi);
        Self::sum(s.hi, s.lo + low.lo)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Double {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let p = Self::product(self.hi, b.hi);
        Self::sum(p.hi, p.lo + (self.hi * b.lo + self.lo * b.hi))
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        let q = Double::from(self.hi / b.hi);
        let q = q + Double::from((self - q * b).hi / b.hi);
        q + Double::from((self - q * b).hi / b.hi)
    }
}

impl PartialOrd for Double {
    fn partial_cmp(&self, b: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&b.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&b.lo),
            order => order,
        }
    }
}
