//! `f64`: native double precision.

use super::coefficients_f64::{CONSTANTS, TABLE};
use super::float::Float;
use super::format::Native;
use super::pair::Pair;
use super::probability::pair_of_f64;
use super::table::Table;
use super::turn::select_if_odd;
use crate::arithmetic::constants::Constants;
use crate::scalar::{BY_SELECTS, Scalar};

pub(crate) const fn power_of_two(n: i32) -> f64 {
    f64::from_bits((n.wrapping_add(1023) as u64) << 52)
}

impl Scalar for f64 {
    const ZERO: f64 = 0.0;
    const QUARTER: f64 = 0.25;
    const HALF: f64 = 0.5;
    const ONE: f64 = 1.0;
    const INFINITY: f64 = f64::INFINITY;
    const NAN: f64 = f64::NAN;
    const MIN_NORMAL: f64 = f64::MIN_POSITIVE;
    const MAX: f64 = f64::MAX;
    // FRAC_PI_2 as f64 lies 6.1e-17 inside π/2.
    const HALF_PI_DOWN: f64 = core::f64::consts::FRAC_PI_2;

    #[inline(always)]
    fn int(n: i16) -> f64 {
        f64::from(n)
    }

    #[inline(always)]
    fn is_nan(self) -> bool {
        f64::is_nan(self)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }

    #[inline(always)]
    fn abs(self) -> f64 {
        f64::abs(self)
    }

    #[inline(always)]
    fn sign_bit(self) -> u32 {
        (self.to_bits() >> 63) as u32
    }

    #[inline(always)]
    fn probabilities(a: f64, b: f64) -> (f64, f64) {
        pair_of_f64::<BY_SELECTS>(a, b)
    }

    #[inline(always)]
    fn swap_if_odd(n: u32, a: f64, b: f64) -> (f64, f64) {
        let difference = (a.to_bits() ^ b.to_bits()) & u64::from(n & 1).wrapping_neg();
        (
            f64::from_bits(a.to_bits() ^ difference),
            f64::from_bits(b.to_bits() ^ difference),
        )
    }

    #[inline(always)]
    fn swap_factors_if_odd(n: u32, a: f64, b: f64) -> (f64, f64) {
        if !BY_SELECTS {
            return Self::swap_if_odd(n, a, b);
        }
        let (a, b) = select_if_odd(n, a.to_bits(), b.to_bits());
        (f64::from_bits(a), f64::from_bits(b))
    }

    #[inline(always)]
    fn negate_if_odd(self, n: u32) -> f64 {
        f64::from_bits(self.to_bits() ^ (u64::from(n) << (u64::BITS - 1)))
    }

    #[inline(always)]
    fn copysign(self, sign: f64) -> f64 {
        f64::copysign(self, sign)
    }

    #[inline(always)]
    fn sqrt(self) -> f64 {
        #[cfg(feature = "std")]
        return f64::sqrt(self);
        #[cfg(not(feature = "std"))]
        libm::sqrt(self)
    }
}

impl Float for f64 {
    const NEGLIGIBLE: f64 = power_of_two(-34);
    const ROOT_UP: f64 = power_of_two(54);
    const ROOT_DOWN: f64 = power_of_two(-27);
    const ROOT_EXPONENT: i32 = 54;
    const COUNTS_QUARTERS: f64 = power_of_two(50);
    const CBRT_UP: f64 = power_of_two(300);
    const CBRT_DOWN: f64 = power_of_two(-100);
    const CBRT_STEPS: usize = 1;
    const CBRT_THIRD: f64 = 1.0 / 3.0;
    const CBRT_SECOND: f64 = 2.0 / 9.0;
    const CBRT_FOURTH: f64 = 14.0 / 81.0;
    const CBRT_RAISE: f64 = 1.0 + power_of_two(-26);
    const ROOT_HALF: f64 = core::f64::consts::FRAC_1_SQRT_2;
    const TINY_SINE: f64 = power_of_two(-105);
    const TINY_UP: f64 = power_of_two(70);
    const TINY_SHARE: f64 = power_of_two(-141);
    const SLIGHT: f64 = power_of_two(-55);
    const EXPONENT_LIMIT: f64 = power_of_two(20);
    const LEAST_EXPONENT: i32 = -1022;
    const TWICE_EXPONENT: i32 = 2000;
    const LIFT_BELOW: f64 = power_of_two(-500);
    const LIFT: f64 = power_of_two(512);
    const DROP: f64 = power_of_two(-512);
    const ROOT_DROP: f64 = power_of_two(-256);
    const LIFT_EXPONENT: i32 = 512;
    const EXACT_CUBE: bool = true;

    #[inline(always)]
    fn last_bits(self) -> u32 {
        self.to_bits() as u32
    }

    #[inline(always)]
    fn to_u32(self) -> u32 {
        self as u32
    }

    #[inline(always)]
    fn from_i32(n: i32) -> f64 {
        f64::from(n)
    }

    #[inline]
    fn ln(self) -> f64 {
        libm::log(self)
    }

    #[inline]
    fn ln_1p(self) -> f64 {
        libm::log1p(self)
    }

    #[inline(always)]
    fn nearest(self) -> (f64, i32) {
        // Its last place is 1, and the lower half of its bits 0.
        const CARRIER: f64 = 6_755_399_441_055_744.0;
        let sum = self + CARRIER;
        (sum - CARRIER, sum.to_bits() as i32)
    }

    #[inline(always)]
    fn exp2(n: i32) -> f64 {
        f64::from_bits((i64::from(n.wrapping_add(1023)) as u64) << 52)
    }

    #[inline]
    fn scale(self, n: i32) -> f64 {
        libm::scalbn(self, n)
    }

    #[inline(always)]
    fn split(self, least: f64) -> (f64, i32) {
        let tiny = self < f64::MIN_POSITIVE;
        let x = f64::select(tiny, self * power_of_two(53), self);
        let shift = if tiny { -53 } else { 0 };
        let (m, e) = x.split_normal(least);
        (m, e.wrapping_add(shift))
    }

    #[inline(always)]
    fn split_normal(self, least: f64) -> (f64, i32) {
        // Exponent over the least significand.
        let e = (self.to_bits().wrapping_sub(least.to_bits()) as i64) >> 52;
        let m = f64::from_bits(self.to_bits().wrapping_sub((e << 52) as u64));
        (m, e as i32)
    }

    #[inline(always)]
    fn leading_half(self) -> f64 {
        f64::from_bits(self.to_bits() & !0x7FF_FFFF)
    }

    #[inline(always)]
    fn cube_head(self) -> f64 {
        f64::from_bits(self.to_bits() & !0xFF_FFFF_FFFF)
    }

    #[inline(always)]
    fn exponent_factor(self) -> f64 {
        f64::from_bits(self.to_bits() & !0x7FF)
    }

    #[inline(always)]
    fn cbrt_recip_guess(self) -> f64 {
        // Divides the exponent by −3; the constant restores the bias and centres the error of the
        // first step.
        f64::from_bits(0x553E_ECAA_AAAA_A800_u64.wrapping_sub(self.to_bits() / 3))
    }
}

impl Native for f64 {
    const CONSTANTS: Constants<Pair<f64>> = CONSTANTS;
    const TABLE: Table<f64> = TABLE;
}
