//! [`Lambert`]: cos θ = max(u₁, u₂).

use super::kernel::mul::mul_high;
use super::kernel::sqrt::{complement, sqrt};
use super::law::{Tails, Words};
use super::{spatial, words};
use crate::{CosSin, Lambert};
use ::fixed::types::{I1F31, U0F32};
use rand_core::Rng;

/// 1/π in Q32.
const RECIP_PI: u32 = 1367130551;

#[inline(always)]
fn lobe(cos: u32) -> u32 {
    mul_high(cos, RECIP_PI)
}

impl Words for Lambert {
    type Density = U0F32;
    type Direction = [I1F31; 3];

    #[inline]
    fn pair(self, p: Tails) -> CosSin<i32> {
        spatial::pair(sqrt(p.upper), sqrt(p.lower))
    }

    #[inline]
    fn tails(self, at: CosSin<i32>) -> Tails {
        match spatial::squares(at) {
            Ok((upper, lower)) => Tails { lower, upper },
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
        let x = words::largest::<2, R>(rng);
        words::spatial(x.0 >> 1, complement(words::less(x)), rng)
    }
}
