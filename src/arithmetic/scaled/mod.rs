//! Double-double with an exponent of its own: what `Precise<f64>` computes in where the trailing
//! parts of a plain double-double would underflow.
//!
//! Exponents stay below 2²⁷, so that nothing wraps in sums of two; `wrapping_…` spares their
//! checks.

mod kernel;
#[cfg(test)]
mod tests;

use crate::arithmetic::double::arith::scaled;
use crate::arithmetic::double::{Double, root};
use crate::arithmetic::native::f64::power_of_two;
use crate::scalar::Scalar;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// part·2^exponent with 1 ≤ |part.hi| < 2; zero, ∞ and NaN are the part alone, exponent 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scaled {
    pub(crate) part: Double,
    pub(crate) exponent: i32,
}

/// Beyond 2^±this a number is ∞ or 0: farther than any formula goes on its way to a finite result.
const MOST: i32 = 1 << 26;

/// 1 + x is 1 for x below 2 to the minus this.
const DIGITS: i32 = 120;

impl Scaled {
    /// part·2^exponent, brought to the normal form. `const` for the constants' sake.
    pub(crate) const fn new(part: Double, exponent: i32) -> Self {
        let e = ((part.hi.to_bits() >> 52) & 0x7FF) as i32 - 1023;
        if part.hi == 0.0 || e == 1024 {
            return Scaled {
                part: Double {
                    hi: part.hi,
                    lo: 0.0,
                },
                exponent: 0,
            };
        }
        // At the ends of f64's exponents a step towards the middle, since 2⁻ᵉ below must be a
        // normal number.
        if e > 900 || e < -900 {
            let step = if e > 0 { -200 } else { 200 };
            let power = power_of_two(step);
            let part = Double {
                hi: part.hi * power,
                lo: part.lo * power,
            };
            return Self::new(part, exponent.wrapping_sub(step));
        }
        let whole = exponent.wrapping_add(e);
        if whole > MOST || whole < -MOST {
            let beyond = if whole > 0 { f64::INFINITY } else { 0.0 };
            return Scaled {
                part: Double {
                    hi: if part.hi < 0.0 { -beyond } else { beyond },
                    lo: 0.0,
                },
                exponent: 0,
            };
        }
        let power = power_of_two(-e);
        Scaled {
            part: Double {
                hi: part.hi * power,
                lo: part.lo * power,
            },
            exponent: whole,
        }
    }

    pub(crate) fn from_double(x: Double) -> Self {
        Self::new(x, 0)
    }

    /// 0 < |self| < 2ⁿ, n ≤ 0.
    #[inline(always)]
    pub(crate) fn is_below(self, n: i32) -> bool {
        self.exponent < n
    }

    /// As a double-double; a magnitude beyond 2^±300 becomes 2^±300.
    pub(crate) fn double(self) -> Double {
        const LIMIT: i32 = 300;
        scaled(self.part, power_of_two(self.exponent.clamp(-LIMIT, LIMIT)))
    }

    /// self·2ⁿ.
    pub(crate) fn times_power(self, n: i32) -> Self {
        Self::new(self.part, self.exponent.wrapping_add(n))
    }

    /// (part, e) with self = part·2^(n·e).
    fn split_by(self, n: i32) -> (Double, i32) {
        let rest = self.exponent.rem_euclid(n);
        (
            scaled(self.part, power_of_two(rest)),
            self.exponent.wrapping_sub(rest) / n,
        )
    }

    fn is_ordinary(self) -> bool {
        self.part.hi.is_finite() && self.part.hi != 0.0
    }
}

impl Add for Scaled {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        if !(self.is_ordinary() && b.is_ordinary()) {
            return if self.part.hi == 0.0 && b.is_ordinary() {
                b
            } else if b.part.hi == 0.0 && self.is_ordinary() {
                self
            } else {
                Self::new(Double::from_f64(self.part.hi + b.part.hi), 0)
            };
        }
        let (large, small) = if self.exponent < b.exponent {
            (b, self)
        } else {
            (self, b)
        };
        let gap = large.exponent.wrapping_sub(small.exponent);
        if gap > DIGITS {
            return large;
        }
        let sum = large.part + scaled(small.part, power_of_two(gap.wrapping_neg()));
        Self::new(sum, large.exponent)
    }
}

impl Sub for Scaled {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Scaled {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        Self::new(self.part * b.part, self.exponent.wrapping_add(b.exponent))
    }
}

impl Div for Scaled {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        Self::new(self.part / b.part, self.exponent.wrapping_sub(b.exponent))
    }
}

impl Neg for Scaled {
    type Output = Self;
    fn neg(self) -> Self {
        Scaled {
            part: -self.part,
            ..self
        }
    }
}

impl PartialOrd for Scaled {
    fn partial_cmp(&self, b: &Self) -> Option<Ordering> {
        if self.is_ordinary() && b.is_ordinary() {
            (*self - *b).part.hi.partial_cmp(&0.0)
        } else {
            // Zero and ∞ are told from any part between 1 and 2.
            self.part.hi.partial_cmp(&b.part.hi)
        }
    }
}

impl PartialEq for Scaled {
    fn eq(&self, b: &Self) -> bool {
        self.partial_cmp(b) == Some(Ordering::Equal)
    }
}

impl Scalar for Scaled {
    const ZERO: Self = Self::new(Double::ZERO, 0);
    const QUARTER: Self = Self::new(Double::QUARTER, 0);
    const HALF: Self = Self::new(Double::HALF, 0);
    const ONE: Self = Self::new(Double::ONE, 0);
    const INFINITY: Self = Self::new(Double::INFINITY, 0);
    const NAN: Self = Self::new(Double::NAN, 0);
    const MIN_NORMAL: Self = Self::new(Double::MIN_NORMAL, 0);
    const MAX: Self = Self::new(Double::MAX, 0);
    const HALF_PI_DOWN: Self = Self::new(Double::HALF_PI_DOWN, 0);

    fn int(n: i16) -> Self {
        Self::from_double(Double::int(n))
    }
    fn is_nan(self) -> bool {
        self.part.is_nan()
    }
    fn is_finite(self) -> bool {
        self.part.is_finite()
    }
    fn abs(self) -> Self {
        Scaled {
            part: self.part.abs(),
            ..self
        }
    }
    fn sign_bit(self) -> u32 {
        self.part.sign_bit()
    }
    fn swap_if_odd(n: u32, a: Self, b: Self) -> (Self, Self) {
        if n & 1 == 1 { (b, a) } else { (a, b) }
    }
    fn negate_if_odd(self, n: u32) -> Self {
        Scaled {
            part: self.part.negate_if_odd(n),
            ..self
        }
    }
    fn copysign(self, sign: Self) -> Self {
        Scaled {
            part: self.part.copysign(sign.part),
            ..self
        }
    }
    fn sqrt(self) -> Self {
        let (part, e) = self.split_by(2);
        Self::new(root::sqrt(part), e)
    }
}
