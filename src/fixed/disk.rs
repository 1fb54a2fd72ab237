//! [`Disk`]: Kepler's equation.

use super::kernel::cbrt::{THIRD, cbrt};
use super::kernel::kepler::from_end;
use super::kernel::mul::mul_high;
use super::kernel::turn::{cos_sin, quarter};
use super::law::{Tails, Words};
use super::{planar, words};
use crate::{CosSin, Disk};
use ::fixed::types::{I1F31, U0F32};
use rand_core::Rng;

/// 1/π and 2/π in Q32.
const RECIP_PI: u32 = 1367130551;
const TWO_OVER_PI: u32 = 2734261102;

#[inline(always)]
fn lobe(cos: u32) -> u32 {
    mul_high(mul_high(cos, cos), TWO_OVER_PI)
}

/// The nearer tail ½ − |θ|/π − sin |θ| cos θ / π, for `bulge` = 2 sin |θ| cos θ in Q31.
#[inline(always)]
fn tails(magnitude: u32, bulge: u32, sign: i32) -> Tails {
    let flat = (1 << 31) - (magnitude << 1);
    planar::tails(u32::saturating_sub(flat, mul_high(bulge, RECIP_PI)), sign)
}

impl Words for Disk {
    type Density = U0F32;
    type Direction = [I1F31; 2];

    #[inline]
    fn pair(self, p: Tails) -> CosSin<i32> {
        let (p, sign) = planar::nearer(p);
        let (sin, cos) = quarter(from_end(cbrt(p))); // from the end they change places
        planar::pair(cos, sin, sign)
    }

    #[inline]
    fn turn(self, p: Tails) -> i32 {
        let (p, sign) = planar::nearer(p);
        let turn = ((1 << 30) - (from_end(cbrt(p)) >> 2)) as i32;
        if sign == 0 { turn } else { -turn }
    }

    #[inline]
    fn tails(self, at: CosSin<i32>) -> Tails {
        match planar::above(at) {
            Ok(at) => {
                let (cos, sin) = (
                    (at.cos as u32) << 1,
                    at.sin.unsigned_abs().min(i32::MAX as u32) << 1,
                );
                tails(planar::turn(at), mul_high(cos, sin), at.sin)
            }
            Err(outside) => outside,
        }
    }

    #[inline]
    fn tails_at(self, turn: i32) -> Tails {
        match planar::magnitude(turn) {
            Ok(magnitude) => tails(magnitude, cos_sin(magnitude << 1).1.max(0) as u32, turn),
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

    /// ∛(2p) is the largest of three words, so that no root is taken; the others' lowest bits give the sign.
    #[inline]
    fn draw<R: Rng + ?Sized>(self, rng: &mut R) -> [I1F31; 2] {
        let (largest, low) = words::largest::<3, R>(rng);
        let (sin, cos) = quarter(from_end(mul_high(largest, THIRD)));
        words::planar(cos, sin, low << 31)
    }
}
