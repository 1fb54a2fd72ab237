//! Real exponents.

use super::drawn::Drawn;
use super::kernel::halve;
use super::kernel::mul::mul_high;
use super::kernel::normal::{normal, normal_long};
use super::law::Formulas;
use super::q31::log::{Number, Part, exp2, exp2_up, log2, one_less_exp2};
use super::q31::recip::half_recip;
use super::q31::sqrt::{complement, scaled};
use super::q31::turn::ONE;
use super::q31::{Q31, draw};
use super::spatial;
use super::tails::Tails;
use super::weight;
use crate::CosSin;
use ::fixed::types::{I1F31, U16F16};
use rand_core::TryRng;

/// The law ∝ cosᵏθ of [`CosPower`](crate::CosPower), its exponent k in fixed point from 0 to 65536
/// − 2⁻¹⁶.
///
/// It holds k + 1, 1/(k + 1) and (k + 1)/2π, worked out once, so that no operation divides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CosPower {
    exponent: u32,
    /// k, k + 1, 1/(k + 1) and (k + 1)/2π.
    power: Number,
    successor: Number,
    recip: Number,
    scale: Number,
}

/// 1/(2π) in Q34: its mantissa, with e = −2.
const RECIP_TAU: Number = Number {
    m: 2734261102,
    e: -2,
};

impl CosPower {
    /// The law ∝ cosᵏθ: every `k` is one.
    #[inline]
    pub fn new(k: U16F16) -> Self {
        let exponent = k.to_bits();
        // k + 1 in Q16 takes 33 bits, which are halved only if they have to be.
        let (successor, e) = match exponent.checked_add(1 << 16) {
            Some(sum) => {
                let (m, shift) = normal(sum);
                (m, 16i32.wrapping_sub(shift as i32))
            }
            None => ((1 << 31) | (exponent.wrapping_add(1 << 16) >> 1), 17),
        };
        // One more step of Newton's: y + y e, e = 1 − 2 d y.
        let y = half_recip(successor);
        let e2 = (u64::from(successor).wrapping_mul(u64::from(y))).wrapping_neg() << 1;
        let error = (e2 as i64 >> 32) as i32;
        let change = ((i64::from(y).wrapping_mul(i64::from(error))) >> 32) as i32;
        let (k, shift) = normal(exponent);
        let successor = Number { m: successor, e };
        CosPower {
            exponent,
            power: Number {
                m: k,
                e: 16i32.wrapping_sub(shift as i32),
            },
            successor,
            recip: Number {
                m: y.saturating_add_signed(change),
                e: 1i32.wrapping_sub(e),
            },
            scale: RECIP_TAU.times(successor),
        }
    }

    /// The exponent k.
    #[inline]
    pub fn exponent(&self) -> U16F16 {
        U16F16::from_bits(self.exponent)
    }

    /// (cos θ, sin θ) at y = −log₂ cos θ.
    #[inline(always)]
    fn at_log(y: Number) -> (u32, u32) {
        let (value, whole) = exp2(y);
        let cos = (value >> whole.min(31)).min(ONE);
        let sin = if y.e < -1 {
            // sin² = 1 − 2^(−2y), which keeps its digits beside the axis.
            let (m, e) = one_less_exp2(Number {
                m: y.m,
                e: y.e.wrapping_add(1),
            });
            halve(scaled(m, e))
        } else {
            complement(!(u64::from(cos) << 33))
        };
        (cos, sin)
    }

    /// log₂ of 1/(1 − u), over k + 1.
    #[inline(always)]
    fn log_cos(self, lower: u64, upper: u64) -> Number {
        let small = upper >> 63 == 0;
        let (m, e) = normal_long(if small { upper } else { lower });
        let log = log2(if small {
            Part::Small(m, e)
        } else {
            Part::LessThanOne(m, e)
        });
        log.times(self.recip)
    }

    /// −log₂ cos θ, from the smaller of cos θ and sin θ, neither of which is 0.
    #[inline(always)]
    fn log_of(at: CosSin<i32>) -> Number {
        let (cos, sin) = ((at.cos as u32) << 1, (at.sin as u32) << 1);
        let beside_axis = sin < cos;
        // cos² = 1 − sin² beside the axis; down to ½ the cosine is still the greater part of 1.
        let (m, e) = if beside_axis {
            let (m, shift) = normal(sin);
            let (m, more) = normal(mul_high(m, m));
            (m, shift.wrapping_mul(2).wrapping_add(more))
        } else {
            normal(if cos >> 31 == 0 { cos } else { !cos })
        };
        let log = log2(if beside_axis || cos >> 31 != 0 {
            Part::LessThanOne(m, e)
        } else {
            Part::Small(m, e)
        });
        Number {
            m: log.m,
            e: log.e.wrapping_sub(i32::from(beside_axis)),
        }
    }

    /// Whether cosᵏθ > 0: at cos θ = 0 for k = 0 alone.
    #[inline(always)]
    fn above(self, at: CosSin<i32>) -> bool {
        at.cos > 0 || (at.cos == 0 && self.exponent == 0)
    }

    /// (k+1) cosᵏθ / 2π times `factor` in Q32, in Q16.
    #[inline(always)]
    fn lobe(self, at: CosSin<i32>, factor: u32) -> U16F16 {
        let (value, whole) = if at.sin == 0 || self.exponent == 0 {
            (1 << 31, 0)
        } else {
            exp2(Self::log_of(at).times(self.power))
        };
        let product = mul_high(mul_high(self.scale.m, factor), value);
        // Q31 and 2^e·2^−whole, to Q16.
        let shift = 15u32.wrapping_add(whole).wrapping_sub(self.scale.e as u32);
        U16F16::from_bits(if shift < 32 { product >> shift } else { 0 })
    }
}

/// Apart, so that its stack is free again before the logarithm takes its own.
#[inline(never)]
fn at_turn(turn: i32) -> Result<CosSin<i32>, Tails> {
    spatial::at_turn::<Q31>(turn)
}

impl Formulas<Q31> for CosPower {
    type Density = U16F16;
    type Direction = [I1F31; 3];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        if p.upper == 0 {
            return spatial::pair::<Q31>(0, 1 << 31);
        }
        if p.lower == 0 {
            return spatial::pair::<Q31>(1 << 31, 0);
        }
        let long = |word: u32| u64::from(word) << 32;
        let (cos, sin) = Self::at_log(self.log_cos(long(p.lower), long(p.upper)));
        spatial::pair::<Q31>(cos, sin)
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        if at.sin < 0 {
            return Tails::BELOW;
        }
        if at.cos <= 0 {
            return Tails::ABOVE;
        }
        if at.sin == 0 {
            return Tails::BELOW;
        }
        let (value, whole) = exp2(Self::log_of(at).times(self.successor));
        Tails::from_upper(if whole == 0 {
            (value.min(i32::MAX as u32)) << 1
        } else {
            value >> (whole.wrapping_sub(1)).min(31)
        })
    }

    #[inline]
    fn tails(self, turn: i32) -> Tails {
        match at_turn(turn) {
            Ok(at) => self.unwarp_tails(at),
            Err(outside) => outside,
        }
    }

    #[inline]
    fn density(self, at: CosSin<i32>) -> U16F16 {
        if at.sin < 0 || !self.above(at) {
            return U16F16::ZERO;
        }
        self.lobe(at, u32::MAX).max(U16F16::from_bits(1))
    }

    #[inline]
    fn pdf(self, turn: i32) -> U16F16 {
        match spatial::at_turn::<Q31>(turn) {
            Ok(at) if self.above(at) => self.lobe(at, (at.sin as u32) << 1),
            _ => U16F16::ZERO,
        }
    }

    /// 2/(k+1) · 2^((k−1) y), y = −log₂ cos θ.
    #[inline]
    fn lambert_weight(self, at: CosSin<i32>) -> U16F16 {
        const ONE: u32 = 1 << 16;
        let at_horizon = match self.exponent {
            ..ONE => U16F16::ZERO,
            ONE => U16F16::ONE,
            _ => U16F16::MAX,
        };
        weight::within(at, false, at_horizon, || {
            let (m, shift) = normal(self.exponent.abs_diff(ONE));
            let beyond_one = Number {
                m,
                e: 16i32.wrapping_sub(shift as i32),
            };
            let (value, whole) = if at.sin == 0 || self.exponent == ONE {
                (1 << 31, 0)
            } else if self.exponent < ONE {
                let (value, whole) = exp2(Self::log_of(at).times(beyond_one));
                (value, (whole as i32).wrapping_neg())
            } else {
                exp2_up(Self::log_of(at).times(beyond_one))
            };
            // Q31 and 2^e·2^whole, twice.
            let shift = self.recip.e.wrapping_add(whole).wrapping_add(1);
            weight::q16(mul_high(self.recip.m, value), shift)
        })
    }

    /// cos θ = u^(1/(k+1)) of two words: both tails down to 2⁻⁶⁴.
    #[inline]
    fn try_draw<R: TryRng + ?Sized>(self, rng: &mut R) -> Result<Drawn<[I1F31; 3]>, R::Error> {
        let u = draw::long(rng)? | 1;
        let (cos, sin) = Self::at_log(self.log_cos(u.wrapping_neg(), u));
        draw::spatial(cos, sin, rng)
    }
}
