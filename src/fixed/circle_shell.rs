//! [`CircleShell`]: sin θ = 2u − 1.

use super::kernel::sqrt::complement;
use super::law::{Tails, Words};
use super::{planar, words};
use crate::{CircleShell, CosSin};
use ::fixed::types::{I1F31, U0F32};
use rand_core::Rng;

#[inline(always)]
fn lobe(cos: u32) -> u32 {
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

impl Words for CircleShell {
    type Density = U0F32;
    type Direction = [I1F31; 2];

    #[inline]
    fn pair(self, p: Tails) -> CosSin<i32> {
        let (p, sign) = planar::nearer(p);
        let v = if p >> 31 == 0 { p << 1 } else { u32::MAX };
        planar::pair(
            complement(u64::from(v) << 32),
            (1 << 31) - p.min(1 << 31),
            sign,
        )
    }

    #[inline]
    fn turn(self, p: Tails) -> i32 {
        let at = self.pair(p);
        let turn = planar::turn(at) as i32;
        if at.sin < 0 { -turn } else { turn }
    }

    #[inline]
    fn tails(self, at: CosSin<i32>) -> Tails {
        match planar::above(at) {
            Ok(at) => tails_of_sine(at.sin),
            Err(outside) => outside,
        }
    }

    #[inline]
    fn tails_at(self, turn: i32) -> Tails {
        match planar::magnitude(turn) {
            Ok(_) => tails_of_sine(super::kernel::turn::cos_sin(turn as u32).1),
            Err(outside) => outside,
        }
    }

    #[inline]
    fn density(self, at: CosSin<i32>) -> U0F32 {
        planar::density(at.cos, lobe)
    }

    #[inline]
    fn pdf(self, turn: i32) -> U0F32 {
        planar::pdf(turn, lobe)
    }

    /// |sin θ| is uniform: v = 1 − |sin θ| from two words, and its lowest bit the sign.
    #[inline]
    fn draw<R: Rng + ?Sized>(self, rng: &mut R) -> [I1F31; 2] {
        let v = words::long(rng);
        words::planar(
            complement(v | 1),
            !((v >> 32) as u32) >> 1,
            (v as u32) << 31,
        )
    }
}
