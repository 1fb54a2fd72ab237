//! [`CircleShell`]: sin θ = 2u − 1.

use super::drawn::Drawn;
use super::format::Format;
use super::law::Formulas;
use super::planar;
use super::tails::Tails;
use super::weight;
use crate::{CircleShell, CosSin};
use ::fixed::types::U16F16;
use rand_core::TryRng;

#[inline(always)]
fn lobe<F: Format>(cos: u32) -> u32 {
    cos >> 1
}

/// ½ + sin θ / 2 in Q32 of sin θ in Q31: exact.
#[inline(always)]
fn tails_of_sine(sin: i32) -> Tails {
    let lower = (sin as u32).wrapping_add(1 << 31);
    Tails {
        lower,
        upper: (!lower).saturating_add(1),
    }
}

impl<F: Format> Formulas<F> for CircleShell {
    type Density = F::Probability;
    type Direction = [F::Component; 2];

    #[inline]
    fn warp_tails(self, p: Tails) -> CosSin<i32> {
        let (p, sign) = planar::nearer(p);
        let v = if p >> 31 == 0 { p << 1 } else { u32::MAX };
        planar::pair::<F>(
            F::complement(v),
            (1u32 << 31).wrapping_sub(p.min(1 << 31)),
            sign,
        )
    }

    #[inline]
    fn quantile_tails(self, p: Tails) -> i32 {
        let at = Formulas::<F>::warp_tails(self, p);
        let turn = planar::turn::<F>(at) as i32;
        if at.sin < 0 {
            turn.wrapping_neg()
        } else {
            turn
        }
    }

    #[inline]
    fn unwarp_tails(self, at: CosSin<i32>) -> Tails {
        match planar::above(at) {
            Ok(at) => tails_of_sine(at.sin),
            Err(outside) => outside,
        }
    }

    #[inline]
    fn tails(self, turn: i32) -> Tails {
        match planar::magnitude(turn) {
            Ok(_) => tails_of_sine(F::cos_sin(turn as u32).1),
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
        weight::within(at, true, U16F16::ONE, || U16F16::ONE)
    }

    #[inline]
    fn try_draw<R: TryRng + ?Sized>(
        self,
        rng: &mut R,
    ) -> Result<Drawn<[F::Component; 2]>, R::Error> {
        F::chord(rng)
    }
}
