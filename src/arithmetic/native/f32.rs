//! `f32`: native single precision; no operation touches `f64`.

use super::coefficients_f32::{CONSTANTS, TABLE};
use super::float::Float;
use super::format::Native;
use super::pair::Pair;
use super::probability;
use super::sqrt::sqrt;
use super::table::Table;
use super::turn::select_if_odd;
use crate::arithmetic::constants::Constants;
use crate::scalar::{BY_SELECTS, Scalar};

pub(crate) const fn power_of_two(n: i32) -> f32 {
    f32::from_bits(((127 + n) as u32) << 23)
}

impl Scalar for f32 {
    const ZERO: f32 = 0.0;
    const QUARTER: f32 = 0.25;
    const HALF: f32 = 0.5;
    const ONE: f32 = 1.0;
    const INFINITY: f32 = f32::INFINITY;
    const NAN: f32 = f32::NAN;
    const MIN_NORMAL: f32 = f32::MIN_POSITIVE;
    const MAX: f32 = f32::MAX;
    // FRAC_PI_2 as f32 lies 4.4e-8 beyond π/2.
    const HALF_PI_DOWN: f32 = f32::from_bits(core::f32::consts::FRAC_PI_2.to_bits() - 1);

    #[inline(always)]
    fn int(n: i16) -> f32 {
        f32::from(n)
    }

    #[inline(always)]
    fn is_nan(self) -> bool {
        f32::is_nan(self)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        f32::is_finite(self)
    }

    #[inline(always)]
    fn abs(self) -> f32 {
        f32::abs(self)
    }

    #[inline(always)]
    fn sign_bit(self) -> u32 {
        self.to_bits() >> 31
    }

    #[inline(always)]
    fn probability(self) -> f32 {
        probability::of_f32::<BY_SELECTS>(self)
    }

    #[inline(always)]
    fn probabilities(a: f32, b: f32) -> (f32, f32) {
        probability::pair_of_f32::<BY_SELECTS>(a, b)
    }

    #[inline(always)]
    fn swap_if_odd(n: u32, a: f32, b: f32) -> (f32, f32) {
        let difference = (a.to_bits() ^ b.to_bits()) & (n & 1).wrapping_neg();
        (
            f32::from_bits(a.to_bits() ^ difference),
            f32::from_bits(b.to_bits() ^ difference),
        )
    }

    #[inline(always)]
    fn swap_factors_if_odd(n: u32, a: f32, b: f32) -> (f32, f32) {
        if !BY_SELECTS {
            return Self::swap_if_odd(n, a, b);
        }
        let (a, b) = select_if_odd(n, a.to_bits(), b.to_bits());
        (f32::from_bits(a), f32::from_bits(b))
    }

    #[inline(always)]
    fn negate_if_odd(self, n: u32) -> f32 {
        f32::from_bits(self.to_bits() ^ (n << (u32::BITS - 1)))
    }

    #[inline(always)]
    fn copysign(self, sign: f32) -> f32 {
        f32::copysign(self, sign)
    }

    #[inline(always)]
    fn sqrt(self) -> f32 {
        // The same bits each way: a root is rounded once.
        let by_instruction = cfg!(any(
            feature = "std",
            target_feature = "sse2",
            all(target_arch = "aarch64", target_feature = "neon")
        ));
        if by_instruction {
            instruction(self)
        } else {
            sqrt(self)
        }
    }
}

/// libm's root is inline assembly on these processors, through which no loop becomes vectors.
#[inline(always)]
fn instruction(x: f32) -> f32 {
    #[cfg(feature = "std")]
    return f32::sqrt(x);
    #[cfg(not(feature = "std"))]
    libm::sqrtf(x)
}

impl Float for f32 {
    const NEGLIGIBLE: f32 = power_of_two(-18);
    const ROOT_UP: f32 = power_of_two(24);
    const ROOT_DOWN: f32 = power_of_two(-12);
    const ROOT_EXPONENT: i32 = 24;
    const COUNTS_QUARTERS: f32 = power_of_two(21);
    const CBRT_UP: f32 = power_of_two(60);
    const CBRT_DOWN: f32 = power_of_two(-20);
    const CBRT_STEPS: usize = 0;
    const CBRT_THIRD: f32 = 1.0 / 3.0;
    const CBRT_SECOND: f32 = 2.0 / 9.0;
    const CBRT_FOURTH: f32 = 14.0 / 81.0;
    const CBRT_RAISE: f32 = 1.0 + power_of_two(-12);
    const ROOT_HALF: f32 = core::f32::consts::FRAC_1_SQRT_2;
    const TINY_SINE: f32 = power_of_two(-40);
    const TINY_UP: f32 = power_of_two(20);
    const TINY_SHARE: f32 = power_of_two(-41);
    const SLIGHT: f32 = power_of_two(-26);
    const EXPONENT_LIMIT: f32 = power_of_two(20);
    const LEAST_EXPONENT: i32 = -126;
    const TWICE_EXPONENT: i32 = 240;
    const LIFT_BELOW: f32 = power_of_two(-60);
    const LIFT: f32 = power_of_two(64);
    const DROP: f32 = power_of_two(-64);
    const ROOT_DROP: f32 = power_of_two(-32);
    const LIFT_EXPONENT: i32 = 64;
    const EXACT_CUBE: bool = false;

    #[inline(always)]
    fn last_bits(self) -> u32 {
        self.to_bits()
    }

    #[inline(always)]
    fn to_u32(self) -> u32 {
        self as u32
    }

    #[inline(always)]
    fn from_i32(n: i32) -> f32 {
        n as f32
    }

    #[inline]
    fn ln(self) -> f32 {
        libm::logf(self)
    }

    #[inline]
    fn ln_1p(self) -> f32 {
        libm::log1pf(self)
    }

    #[inline(always)]
    fn nearest(self) -> (f32, i32) {
        // Its last place is 1.
        const CARRIER: f32 = 12_582_912.0;
        let sum = self + CARRIER;
        let n = sum.to_bits().wrapping_sub(CARRIER.to_bits()) as i32;
        (sum - CARRIER, n)
    }

    #[inline(always)]
    fn exp2(n: i32) -> f32 {
        f32::from_bits((n.wrapping_add(127) as u32) << 23)
    }

    #[inline]
    fn scale(self, n: i32) -> f32 {
        libm::scalbnf(self, n)
    }

    #[inline(always)]
    fn split(self, least: f32) -> (f32, i32) {
        let tiny = self < f32::MIN_POSITIVE;
        let x = f32::select(tiny, self * power_of_two(24), self);
        let shift = if tiny { -24 } else { 0 };
        let (m, e) = x.split_normal(least);
        (m, e.wrapping_add(shift))
    }

    #[inline(always)]
    fn split_normal(self, least: f32) -> (f32, i32) {
        // Exponent over the least significand.
        let e = (self.to_bits().wrapping_sub(least.to_bits()) as i32) >> 23;
        let m = f32::from_bits(self.to_bits().wrapping_sub((e << 23) as u32));
        (m, e)
    }

    #[inline(always)]
    fn leading_half(self) -> f32 {
        f32::from_bits(self.to_bits() & !0xFFF)
    }

    #[inline(always)]
    fn cube_head(self) -> f32 {
        self.leading_half()
    }

    #[inline(always)]
    fn exponent_factor(self) -> f32 {
        f32::from_bits(self.to_bits() & !0xFF)
    }

    #[inline(always)]
    fn cbrt_recip_guess(self) -> f32 {
        // Divides the exponent by −3; the constant restores the bias and centres the error of the
        // first step.
        f32::from_bits(0x54A2_1000_u32.wrapping_sub(self.to_bits() / 3))
    }
}

impl Native for f32 {
    const CONSTANTS: Constants<Pair<f32>> = CONSTANTS;
    const TABLE: Table<f32> = TABLE;
}
