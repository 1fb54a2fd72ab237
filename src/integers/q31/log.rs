//! Logarithms and exponentials to base 2, of numbers held as a mantissa and an exponent.
//!
//! cosᵏθ = 2^(k log₂ cos θ) multiplies a logarithm's relative error by itself, so that logarithms
//! keep all their digits beside 1 too: there they come from the distance to it.

use super::coefficients::{EXP2, EXP2_M1, LOG2};
use crate::integers::kernel::mul::mul_high;
use crate::integers::kernel::normal::normal;

/// m·2ᵉ⁻³². Every product keeps the top bit or the one below it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Number {
    pub(crate) m: u32,
    pub(crate) e: i32,
}

impl Number {
    #[inline(always)]
    pub(crate) fn times(self, b: Number) -> Number {
        let m = mul_high(self.m, b.m);
        let up = (m >> 31) ^ 1;
        Number {
            m: m << up,
            e: self.e.wrapping_add(b.e).wrapping_sub(up as i32),
        }
    }

    /// The integer part and the fraction in Q32; the integer part saturates at 2²⁰.
    #[inline(always)]
    fn parts(self) -> (u32, u32) {
        match self.e {
            ..=-32 => (0, 0),
            -31..=0 => (0, self.m >> self.e.wrapping_neg()),
            1..=20 => (self.m >> 32i32.wrapping_sub(self.e), self.m << self.e),
            _ => (1 << 20, 0),
        }
    }
}

/// −log₂(1 − t) / t in Q31, from 1.44 to 2; t ≤ ½ in Q32.
#[inline(always)]
fn ratio(t: u32) -> u32 {
    let t = t.min(i32::MAX as u32);
    (3u32 << 30).saturating_add_signed(LOG2.at(((t << 1) ^ (1 << 31)) as i32))
}

/// A number of \[0, 1\] by what it or its distance from 1 is: m·2⁻ᵉ⁻³², m ≥ 2³¹.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    /// 1 − m·2⁻ᵉ⁻³², from ½.
    LessThanOne(u32, u32),
    /// m·2⁻ᵉ⁻³², below ½: 1 ≤ e < 128.
    Small(u32, u32),
}

/// −log₂.
#[inline(always)]
pub(crate) fn log2(part: Part) -> Number {
    // One polynomial for both, so that it is linked once.
    let (t, factor) = match part {
        Part::LessThanOne(m, e) => (if e < 32 { m >> e } else { 0 }, m),
        Part::Small(m, _) => (!m, !m),
    };
    let product = mul_high(factor, ratio(t));
    match part {
        Part::LessThanOne(_, e) => {
            let up = (product >> 31) ^ 1;
            Number {
                m: product << up,
                e: 1i32.wrapping_sub(e as i32).wrapping_sub(up as i32),
            }
        }
        Part::Small(_, e) => {
            let (whole, shift) = normal(e);
            Number {
                m: whole | (product << 1).wrapping_shr(32u32.wrapping_sub(shift)),
                e: 32i32.wrapping_sub(shift as i32),
            }
        }
    }
}

/// 2⁻ˣ in Q31 of x in Q32.
#[inline(always)]
fn exp2_fraction(fraction: u32) -> u32 {
    (EXP2.at((fraction ^ (1 << 31)) as i32).max(0) as u32).wrapping_add(1 << 30)
}

/// 2⁻ʸ in Q31, and the power of 2 to shift it down by.
#[inline(always)]
pub(crate) fn exp2(y: Number) -> (u32, u32) {
    let (whole, fraction) = y.parts();
    (exp2_fraction(fraction), whole)
}

/// 2ʸ in Q31, and the power of 2 to shift it up by.
#[inline(always)]
pub(crate) fn exp2_up(y: Number) -> (u32, i32) {
    let (whole, fraction) = y.parts();
    // Of y − 1, since a fraction of 0 is no fraction below 1.
    let whole = (whole as i32).wrapping_add(i32::from(fraction > 0));
    (exp2_fraction(fraction.wrapping_neg()), whole)
}

/// (m, e) with 1 − 2⁻ˣ = m·2⁻ᵉ⁻³², for x ≤ ½.
#[inline(always)]
pub(crate) fn one_less_exp2(x: Number) -> (u32, u32) {
    let (_, fraction) = x.parts();
    let slope = EXP2_M1.at(fraction.min(i32::MAX as u32) as i32) as u32;
    (mul_high(x.m, slope << 1), x.e.unsigned_abs())
}
