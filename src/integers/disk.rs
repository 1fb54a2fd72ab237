//! [`Disk`]: Kepler's equation.

use super::drawn::Drawn;
use super::format::Format;
use super::law::Formulas;
use super::planar;
use super::tails::Tails;
use super::weight;
use crate::{CosSin, Disk};
use ::fixed::types::U16F16;
use rand_core::TryRng;

/// 1/π and 2/π in Q32.
const RECIP_PI: u32 = 1367130551;
const TWO_OVER_PI: u32 = 2734261102;
/// 2^(−1/3) in Q32.
const THIRD: u32 = 3408917802;
/// π/4 in Q32.
const QUARTER_PI: u32 = 3373259426;

#[inline(always)]
fn lobe<F: Format>(cos: u32) -> u32 {
    F::times(F::mul(cos, cos), TWO_OVER_PI)
}

/// The nearer tail ½ − |θ|/π − sin |θ| cos θ / π, for `bulge` = 2 sin |θ| cos θ in Q31.
#[inline(always)]
fn tails<F: Format>(magnitude: u32, bulge: u32, sign: i32) -> Tails {
    let flat = (1u32 << 31).wrapping_sub(magnitude << 1);
    planar::tails(u32::saturating_sub(flat, F::times(bulge, RECIP_PI)), sign)
}

impl<F: Format> Formulas<F> for Disk {
    type Density = F::Probability;
    type Direction = [F::Component; 2];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        let (p, sign) = planar::nearer(p);
        let (sin, cos) = F::quarter(F::from_end(F::cbrt(p))); // from the end they change places
        planar::pair::<F>(cos, sin, sign)
    }

    #[inline]
    fn quantile_tails(self, p: Tails) -> i32 {
        let (p, sign) = planar::nearer(p);
        let turn = ((1u32 << 30).wrapping_sub(F::from_end(F::cbrt(p)) >> 2)) as i32;
        if sign == 0 { turn } else { turn.wrapping_neg() }
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        match planar::above(at) {
            Ok(at) => {
                let (cos, sin) = (
                    (at.cos as u32) << 1,
                    at.sin.unsigned_abs().min(i32::MAX as u32) << 1,
                );
                tails::<F>(planar::turn::<F>(at), F::mul(cos, sin), at.sin)
            }
            Err(outside) => outside,
        }
    }

    #[inline]
    fn tails(self, turn: i32) -> Tails {
        match planar::magnitude(turn) {
            Ok(magnitude) => {
                tails::<F>(magnitude, F::cos_sin(magnitude << 1).1.max(0) as u32, turn)
            }
            Err(outside) => outside,
        }
    }

    #[inline]
    fn density(self, at: CosSin<i32>) -> F::Probability {
        planar::density::<F>(at.cos, lobe::<F>)
    }

    #[inline]
    fn pdf(self, turn: i32) -> F::Probability {
        planar::pdf::<F>(turn, lobe::<F>)
    }

    #[inline]
    fn lambert_weight(self, at: CosSin<i32>) -> U16F16 {
        weight::within(at, true, U16F16::MAX, || {
            weight::over_cosine::<F>(at, QUARTER_PI)
        })
    }

    /// ∛(2p) is the largest of three words, so that no root is taken.
    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        self,
        rng: &mut R,
    ) -> Result<Drawn<[F::Component; 2]>, R::Error> {
        let (largest, sign) = F::largest_of_three(rng)?;
        let (sin, cos) = F::quarter(F::from_end(F::times(largest, THIRD)));
        Ok(planar::direction::<F>(cos, sin, sign))
    }
}
