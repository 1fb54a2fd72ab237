//! [`SphereShell`]: cos θ = max(u₁, u₂, u₃).

use super::kernel::cbrt::cbrt;
use super::kernel::mul::mul_high;
use super::kernel::normal::normal;
use super::kernel::recip::half_recip;
use super::kernel::sqrt::{complement, halve, scaled};
use super::law::{Tails, Words};
use super::{spatial, words};
use crate::{CosSin, SphereShell};
use ::fixed::types::{I1F31, U0F32};
use rand_core::Rng;

/// 3/(2π) in Q32.
const THREE_OVER_TWO_PI: u32 = 2050695827;

#[inline(always)]
fn lobe(cos: u32) -> u32 {
    mul_high(mul_high(cos, cos), THREE_OVER_TWO_PI)
}

impl Words for SphereShell {
    type Density = U0F32;
    type Direction = [I1F31; 3];

    #[inline]
    fn pair(self, p: Tails) -> CosSin<i32> {
        if p.lower == 0 {
            return spatial::pair(1 << 31, 0);
        }
        let cos = cbrt(p.upper);
        // sin² = u (1 + cos) / (1 + cos + cos²), which does not cancel beside the axis.
        let quarter = (1 << 30) + (cos >> 2) + (mul_high(cos, cos) >> 2);
        let less = (quarter >> 31) ^ 1;
        let recip = half_recip(quarter << less);
        let (lower, shift) = normal(p.lower);
        let square = mul_high(mul_high(lower, (1 << 31) + (cos >> 1)), recip);
        let sin = scaled(square, shift.wrapping_sub(less));
        spatial::pair(halve(cos), halve(sin))
    }

    #[inline]
    fn tails(self, at: CosSin<i32>) -> Tails {
        match spatial::squares(at) {
            Ok((square, _)) => Tails::from_upper(mul_high(square, (at.cos as u32) << 1)),
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
        let x = words::largest::<3, R>(rng);
        words::spatial(x.0 >> 1, complement(words::less(x)), rng)
    }
}
