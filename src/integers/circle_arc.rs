//! [`CircleArc`]: θ uniform.

use super::drawn::Drawn;
use super::format::Format;
use super::law::Formulas;
use super::planar;
use super::tails::Tails;
use super::weight;
use crate::{CircleArc, CosSin};
use ::fixed::types::U16F16;
use rand_core::TryRng;

/// 1/π in Q32.
const RECIP_PI: u32 = 1367130551;
/// π/4 in Q32.
const QUARTER_PI: u32 = 3373259426;

/// The tails at |θ|: linear in it.
#[inline(always)]
fn tails(magnitude: u32, sign: i32) -> Tails {
    planar::tails((1u32 << 31).wrapping_sub(magnitude << 1), sign)
}

impl<F: Format> Formulas<F> for CircleArc {
    type Density = F::Probability;
    type Direction = [F::Component; 2];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        let (p, sign) = planar::nearer(p);
        // 2p quarter turns from the end.
        let from_end = if p >> 31 == 0 { p << 1 } else { u32::MAX };
        let (sin, cos) = F::quarter(from_end); // from the end they change places
        planar::pair::<F>(cos, sin, sign)
    }

    #[inline]
    fn quantile_tails(self, p: Tails) -> i32 {
        let (p, sign) = planar::nearer(p);
        let turn = (1i32 << 30).wrapping_sub((p.min(1 << 31) >> 1) as i32);
        if sign == 0 { turn } else { turn.wrapping_neg() }
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        match planar::above(at) {
            Ok(at) => tails(planar::turn::<F>(at), at.sin),
            Err(outside) => outside,
        }
    }

    #[inline]
    fn tails(self, turn: i32) -> Tails {
        match planar::magnitude(turn) {
            Ok(magnitude) => tails(magnitude, turn),
            Err(outside) => outside,
        }
    }

    #[inline]
    fn density(self, at: CosSin<i32>) -> F::Probability {
        F::probability(if at.cos < 0 { 0 } else { RECIP_PI })
    }

    #[inline]
    fn pdf(self, turn: i32) -> F::Probability {
        planar::pdf::<F>(turn, |_| RECIP_PI)
    }

    #[inline]
    fn lambert_weight(self, at: CosSin<i32>) -> U16F16 {
        weight::within(at, true, U16F16::ZERO, || {
            weight::q16(F::times((at.cos as u32) << 1, QUARTER_PI), 0)
        })
    }

    /// One word: its top bit is the sign, the others |θ| in quarter turns.
    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        self,
        rng: &mut R,
    ) -> Result<Drawn<[F::Component; 2]>, R::Error> {
        let word = rng.try_next_u32()?;
        let (cos, sin) = F::quarter((word << 1) | 1);
        Ok(planar::direction::<F>(cos, sin, word))
    }
}
