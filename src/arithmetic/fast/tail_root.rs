//! (cos θ, sin θ) with cosⁿθ a given tail.
//!
//! Method: y = log₂ of the tail over n; cos θ = 2ʸ, and sin²θ = (1 − 2ʸ)(1 + 2ʸ), where for y near
//! 0 the first factor is −y times a polynomial, so that sin θ has its digits beside the axis. For
//! large n y itself may underflow there: sin θ is the root of the logarithm times that of 1/n.

use super::coefficients::LN_SHORT;
use super::fixed::horner;
use super::power::{Exponent, NEAR_ZERO, float, split};
use super::root::{UP, choose};
use crate::Tails;
use crate::arithmetic::native::f32::power_of_two;
use crate::arithmetic::native::sqrt::unusual;
use crate::scalar::{BY_SELECTS, Scalar};
use core::f32::consts::{FRAC_1_SQRT_2, LN_2, LOG2_E};

/// What n ≥ 1 needs for it, worked out once.
#[derive(Clone, Copy, Debug)]
pub struct TailRoot {
    /// −log₂ e · 2⁻²⁴/n.
    slope: f32,
    /// √(log₂ e · 2⁻²⁴/n), which does not underflow.
    side: f32,
}

/// 2⁻²⁴, and its root.
const DOWN: f32 = 1.0 / UP;
const ROOT_DOWN: f32 = 1.0 / 4096.0;
/// √log₂ e.
const ROOT_LOG2_E: f32 = 1.201_122_4;
/// Of the logarithm's argument times 2²⁴.
const LN_UP: [f32; 2] = [LN_SHORT[0], LN_SHORT[1] * DOWN * DOWN];

impl TailRoot {
    pub(crate) fn new(n: f32) -> Self {
        TailRoot {
            slope: -LOG2_E * DOWN / n,
            side: ROOT_LOG2_E * ROOT_DOWN / Scalar::sqrt(n),
        }
    }

    /// (cos θ, sin θ) at the tails p.
    #[inline(always)]
    pub(crate) fn at(self, p: Tails<f32>) -> (f32, f32) {
        self.by::<BY_SELECTS>(p)
    }

    #[inline(always)]
    pub(super) fn by<const SELECTS: bool>(self, p: Tails<f32>) -> (f32, f32) {
        let (lower, upper) = (p.lower(), p.upper());
        if !SELECTS && unusual(upper.to_bits()) {
            return self.at_unusual(p);
        }
        let log = minus_ln_up::<SELECTS>(lower, upper);
        let y = log * self.slope;
        let inside = !SELECTS | (upper > 0.0);
        let (cos, exponent) = if SELECTS {
            // Of a subnormal tail 2ʸ may be subnormal too; at the end it is the tail, 0 or NaN.
            let exponent = Exponent::lifted(y);
            let power = exponent.power() * power_of_two(-64);
            (f32::select(inside, power, upper), exponent)
        } else {
            let exponent = Exponent::of(y);
            (exponent.power(), exponent)
        };
        // y is negative, or −0: the farther from 0, the more its bits.
        let far = (NEAR_ZERO.to_bits().wrapping_sub(y.to_bits()) as i32 >> 31) as u32;
        let part = pick::<SELECTS>(far, || 1.0 - cos, || log * exponent.slope());
        let root = Scalar::sqrt(part * (1.0 + cos));
        let sin = pick::<SELECTS>(far, || root, || root * self.side);
        (cos, if inside { sin } else { lower })
    }

    #[cold]
    fn at_unusual(self, p: Tails<f32>) -> (f32, f32) {
        if p.upper() > 0.0 {
            self.by::<true>(p)
        } else {
            (p.upper(), p.lower())
        }
    }
}

/// `a` if the mask is of ones, else, where it is 0, `b`.
///
/// By selects no comparison is seen, of which a compiler would make a jump, to either side at
/// random.
#[inline(always)]
fn pick<const SELECTS: bool>(mask: u32, a: impl FnOnce() -> f32, b: impl FnOnce() -> f32) -> f32 {
    if SELECTS {
        let (a, b) = (a().to_bits(), b().to_bits());
        f32::from_bits(b ^ (a ^ b) & mask)
    } else if mask != 0 {
        a()
    } else {
        b()
    }
}

/// −2²⁴ ln `upper`, where `lower` is 1 − upper with digits of its own: relative accuracy beside 1
/// too, and no subnormal number for the least of them.
#[inline(always)]
fn minus_ln_up<const SELECTS: bool>(lower: f32, upper: f32) -> f32 {
    let (m, e) = if SELECTS {
        let (m, e) = split(upper * UP);
        (m, e.wrapping_sub(24))
    } else {
        split(upper)
    };
    // Of floats, a comparison gives a mask; on e LLVM would jump, to either side at random.
    let near = if SELECTS {
        upper >= FRAC_1_SQRT_2
    } else {
        e == 0
    };
    let less = choose::<SELECTS>(near, || lower, || 1.0 - m);
    let z = less / (f32::from_bits(m.to_bits().wrapping_sub(24 << 23)) + DOWN);
    z * horner(z * z, &LN_UP) - float(e) * (LN_2 * UP)
}
