//! [`Ball`]: cos θ = max(u₁, u₂, u₃, u₄).

use super::kernel::mul::mul_high;
use super::kernel::normal::normal;
use super::kernel::recip::half_recip;
use super::kernel::sqrt::{complement, fourth, halve, scaled};
use super::law::{Tails, Words};
use super::{spatial, words};
use crate::{Ball, CosSin};
use ::fixed::types::{I1F31, U0F32};
use rand_core::Rng;

/// 2/π in Q32.
const TWO_OVER_PI: u32 = 2734261102;

#[inline(always)]
fn lobe(cos: u32) -> u32 {
    mul_high(mul_high(mul_high(cos, cos), cos), TWO_OVER_PI)
}

impl Words for Ball {
    type Density = U0F32;
    type Direction = [I1F31; 3];

    #[inline]
    fn pair(self, p: Tails) -> CosSin<i32> {
        if p.lower == 0 {
            return spatial::pair(1 << 31, 0);
        }
        let (cos, square) = fourth(p.upper);
        // sin² = u / (1 + cos²), which does not cancel beside the axis.
        let (lower, shift) = normal(p.lower);
        let recip = half_recip((1 << 31) + (square >> 1));
        let sin = scaled(mul_high(lower, recip), shift);
        spatial::pair(cos, halve(sin))
    }

    #[inline]
    fn tails(self, at: CosSin<i32>) -> Tails {
        match spatial::squares(at) {
            Ok((cos, sin)) => Tails {
                lower: sin.saturating_add(mul_high(sin, cos)),
                upper: mul_high(cos, cos),
            },
            Err(outside) => outside,
        }
    }

    #[inline]
    fn density(self, at: CosSin<i32>) -> U0F32 {
        spatial::density(at, lobe)
    }

    #[inline]
    fn pdf(self, turn: i32) -> U0F32 {
        spatial::pdf(turn, lobe)
    }

    #[inline]
    fn draw<R: Rng + ?Sized>(self, rng: &mut R) -> [I1F31; 3] {
        let x = words::largest::<4, R>(rng);
        words::spatial(x.0 >> 1, complement(words::less(x)), rng)
    }
}
