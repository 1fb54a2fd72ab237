//! [`Ball`]: cos θ = max(u₁, u₂, u₃, u₄).

use super::drawn::Drawn;
use super::format::Format;
use super::kernel::halve;
use super::kernel::normal::normal;
use super::law::Formulas;
use super::spatial;
use super::tails::Tails;
use super::weight;
use crate::{Ball, CosSin};
use ::fixed::types::U16F16;
use rand_core::TryRng;

/// 2/π in Q32.
const TWO_OVER_PI: u32 = 2734261102;

#[inline(always)]
fn lobe<F: Format>(cos: u32) -> u32 {
    F::times(F::mul(F::mul(cos, cos), cos), TWO_OVER_PI)
}

impl<F: Format> Formulas<F> for Ball {
    type Density = F::Probability;
    type Direction = [F::Component; 3];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        if p.lower == 0 {
            return spatial::pair::<F>(1 << 31, 0);
        }
        let (cos, square) = F::fourth(p.upper);
        // sin² = u / (1 + cos²), which does not cancel beside the axis.
        let (lower, shift) = normal(p.lower);
        let recip = F::half_recip((square >> 1).wrapping_add(1 << 31));
        let sin = F::scaled(F::mul(lower, recip), shift);
        spatial::pair::<F>(cos, halve(sin))
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        match spatial::squares::<F>(at) {
            Ok((cos, sin)) => Tails {
                lower: sin.saturating_add(F::mul(sin, cos)),
                upper: F::mul(cos, cos),
            },
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
        weight::within(at, false, U16F16::MAX, || {
            let (r, shift) = weight::half_secant::<F>(at);
            weight::q16(F::mul(r, r), shift << 1)
        })
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        self,
        rng: &mut R,
    ) -> Result<Drawn<[F::Component; 3]>, R::Error> {
        F::lobe::<4, R>(rng)
    }
}
