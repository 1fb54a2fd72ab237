//! [`Lambert`]: cos θ = max(u₁, u₂).

use super::drawn::Drawn;
use super::format::Format;
use super::law::Formulas;
use super::spatial;
use super::tails::Tails;
use super::weight;
use crate::{CosSin, Lambert};
use ::fixed::types::U16F16;
use rand_core::TryRng;

/// 1/π in Q32.
const RECIP_PI: u32 = 1367130551;

#[inline(always)]
fn lobe<F: Format>(cos: u32) -> u32 {
    F::times(cos, RECIP_PI)
}

impl<F: Format> Formulas<F> for Lambert {
    type Density = F::Probability;
    type Direction = [F::Component; 3];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        spatial::pair::<F>(F::sqrt(p.upper), F::sqrt(p.lower))
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        match spatial::squares::<F>(at) {
            Ok((upper, lower)) => Tails { lower, upper },
            Err(outside) => outside,
        }
    }

    #[inline]
    fn density(self, at: CosSin<i32>) -> F::Probability {
        spatial::density::<F>(at, lobe::<F>)
    }

    #[inline]
    fn pdf(self, turn: i32) -> F::Probability {
        spatial::pdf::<F>(turn, lobe::<F>)
    }

    #[inline]
    fn lambert_weight(self, at: CosSin<i32>) -> U16F16 {
        weight::within(at, false, U16F16::ONE, || U16F16::ONE)
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        self,
        rng: &mut R,
    ) -> Result<Drawn<[F::Component; 3]>, R::Error> {
        F::lobe::<2, R>(rng)
    }
}
