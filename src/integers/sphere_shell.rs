//! [`SphereShell`]: cos θ = max(u₁, u₂, u₃).

use super::drawn::Drawn;
use super::format::Format;
use super::kernel::halve;
use super::kernel::normal::normal;
use super::law::Formulas;
use super::spatial;
use super::tails::Tails;
use super::weight;
use crate::{CosSin, SphereShell};
use ::fixed::types::U16F16;
use rand_core::TryRng;

/// 3/(2π) in Q32.
const THREE_OVER_TWO_PI: u32 = 2050695827;
/// ⅔ in Q32.
const TWO_THIRDS: u32 = 2863311531;

#[inline(always)]
fn lobe<F: Format>(cos: u32) -> u32 {
    F::times(F::mul(cos, cos), THREE_OVER_TWO_PI)
}

impl<F: Format> Formulas<F> for SphereShell {
    type Density = F::Probability;
    type Direction = [F::Component; 3];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        if p.lower == 0 {
            return spatial::pair::<F>(1 << 31, 0);
        }
        let cos = F::cbrt(p.upper);
        // sin² = u (1 + cos) / (1 + cos + cos²), which does not cancel beside the axis.
        let quarter = (cos >> 2)
            .wrapping_add(1 << 30)
            .wrapping_add(F::mul(cos, cos) >> 2);
        let less = (quarter >> 31) ^ 1;
        let recip = F::half_recip(quarter << less);
        let (lower, shift) = normal(p.lower);
        let square = F::mul(F::mul(lower, (cos >> 1).wrapping_add(1 << 31)), recip);
        let sin = F::scaled(square, shift.wrapping_sub(less));
        spatial::pair::<F>(halve(cos), halve(sin))
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        match spatial::squares::<F>(at) {
            Ok((square, _)) => Tails::from_upper(F::mul(square, (at.cos as u32) << 1)),
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
            weight::over_cosine::<F>(at, TWO_THIRDS)
        })
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        self,
        rng: &mut R,
    ) -> Result<Drawn<[F::Component; 3]>, R::Error> {
        F::lobe::<3, R>(rng)
    }
}
