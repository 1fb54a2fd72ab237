//! Double-double as a working arithmetic: what the `Precise` tiers compute in.

use super::arith::{product, quotient, sum};
use crate::arithmetic::double::{Double, root};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::native::format::Native;
use crate::scalar::Scalar;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `result`, or `leading` alone where that is 0 or ∞, whose trailing part would be NaN.
#[inline(always)]
fn settled(leading: f64, result: Double) -> Double {
    if leading.is_finite() && leading != 0.0 {
        result
    } else {
        Double::from_f64(leading)
    }
}

impl Add for Double {
    type Output = Self;
    #[inline]
    fn add(self, b: Self) -> Self {
        let sum = sum(self, b);
        // Leading parts that cancel leave the trailing ones.
        if sum.hi.is_finite() && sum.hi != 0.0 {
            sum
        } else {
            Double::from_f64(self.hi + b.hi)
        }
    }
}

impl Sub for Double {
    type Output = Self;
    #[inline]
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Double {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        settled(self.hi * b.hi, product(self, b))
    }
}

impl Div for Double {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        settled(self.hi / b.hi, quotient(self, b))
    }
}

impl Neg for Double {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Double {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Scalar for Double {
    const ZERO: Self = Double { hi: 0.0, lo: 0.0 };
    const QUARTER: Self = Double { hi: 0.25, lo: 0.0 };
    const HALF: Self = Double { hi: 0.5, lo: 0.0 };
    const ONE: Self = Double { hi: 1.0, lo: 0.0 };
    const INFINITY: Self = Double {
        hi: f64::INFINITY,
        lo: 0.0,
    };
    const NAN: Self = Double {
        hi: f64::NAN,
        lo: 0.0,
    };
    const MIN_NORMAL: Self = Double {
        hi: f64::MIN_POSITIVE,
        lo: 0.0,
    };
    const MAX: Self = Double {
        hi: f64::MAX,
        lo: 0.0,
    };
    const HALF_PI_DOWN: Self = Double::from_pair(<f64 as Native>::CONSTANTS.half_pi);

    #[inline(always)]
    fn int(n: i16) -> Self {
        Double::from_f64(f64::from(n))
    }
    #[inline(always)]
    fn is_nan(self) -> bool {
        self.hi.is_nan()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.hi.is_finite()
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.negate_if(self.hi.is_sign_negative())
    }
    #[inline(always)]
    fn sign_bit(self) -> u32 {
        self.hi.sign_bit()
    }
    #[inline(always)]
    fn swap_if_odd(n: u32, a: Self, b: Self) -> (Self, Self) {
        let (a_hi, b_hi) = f64::swap_if_odd(n, a.hi, b.hi);
        let (a_lo, b_lo) = f64::swap_if_odd(n, a.lo, b.lo);
        (Double { hi: a_hi, lo: a_lo }, Double { hi: b_hi, lo: b_lo })
    }
    #[inline(always)]
    fn negate_if_odd(self, n: u32) -> Self {
        Double {
            hi: self.hi.negate_if_odd(n),
            lo: self.lo.negate_if_odd(n),
        }
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        self.negate_if(self.hi.is_sign_negative() != sign.hi.is_sign_negative())
    }
    #[inline]
    fn sqrt(self) -> Self {
        root::sqrt(self)
    }
}

impl Holds<f64> for Double {
    #[inline(always)]
    fn from_number(x: f64) -> Self {
        Double::from_f64(x)
    }
}
