//! The laws in integers (feature `fixed`).

mod ball;
mod circle_arc;
mod circle_shell;
mod disk;
mod kernel;
mod lambert;
mod law;
mod planar;
mod spatial;
mod sphere_shell;
mod words;

pub use law::FixedLaw;

use crate::CosSin;
use ::fixed::types::{I0F32, I1F31, U0F32};
use law::Tails;
use rand_core::Rng;

/// A law in integers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fixed<L>(pub L);

#[inline(always)]
fn bits(at: CosSin<I1F31>) -> CosSin<i32> {
    CosSin {
        cos: at.cos.to_bits(),
        sin: at.sin.to_bits(),
    }
}

#[inline(always)]
fn of_bits(at: CosSin<i32>) -> CosSin<I1F31> {
    CosSin {
        cos: I1F31::from_bits(at.cos),
        sin: I1F31::from_bits(at.sin),
    }
}

impl<L: FixedLaw> Fixed<L> {
    /// (cos θ, sin θ) at cdf = `u`.
    #[inline]
    pub fn warp(&self, u: U0F32) -> CosSin<I1F31> {
        of_bits(self.0.pair(Tails::from_lower(u.to_bits())))
    }

    /// (cos θ, sin θ) at sf = `q`.
    #[inline]
    pub fn warp_sf(&self, q: U0F32) -> CosSin<I1F31> {
        of_bits(self.0.pair(Tails::from_upper(q.to_bits())))
    }

    /// cdf at a direction.
    #[inline]
    pub fn unwarp(&self, at: CosSin<I1F31>) -> U0F32 {
        U0F32::from_bits(self.0.tails(bits(at)).lower)
    }

    /// sf at a direction.
    #[inline]
    pub fn unwarp_sf(&self, at: CosSin<I1F31>) -> U0F32 {
        U0F32::from_bits(self.0.tails(bits(at)).upper)
    }

    /// Density at a direction.
    #[inline]
    pub fn density(&self, at: CosSin<I1F31>) -> L::Density {
        self.0.density(bits(at))
    }

    /// Density at θ.
    #[inline]
    pub fn pdf(&self, theta: I0F32) -> L::Density {
        self.0.pdf(theta.to_bits())
    }

    /// P(Θ ≤ θ).
    #[inline]
    pub fn cdf(&self, theta: I0F32) -> U0F32 {
        U0F32::from_bits(self.0.tails_at(theta.to_bits()).lower)
    }

    /// P(Θ > θ).
    #[inline]
    pub fn sf(&self, theta: I0F32) -> U0F32 {
        U0F32::from_bits(self.0.tails_at(theta.to_bits()).upper)
    }

    /// θ at cdf = `p`.
    #[inline]
    pub fn quantile(&self, p: U0F32) -> I0F32 {
        I0F32::from_bits(self.0.turn(Tails::from_lower(p.to_bits())))
    }

    /// θ at sf = `p`.
    #[inline]
    pub fn isf(&self, p: U0F32) -> I0F32 {
        I0F32::from_bits(self.0.turn(Tails::from_upper(p.to_bits())))
    }

    /// Draws a direction.
    #[inline]
    pub fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        self.0.draw(rng)
    }
}

/// (cos, sin) of an angle in turns.
#[inline]
pub fn cos_sin(turn: I0F32) -> CosSin<I1F31> {
    let (cos, sin) = kernel::turn::cos_sin(turn.to_bits() as u32);
    of_bits(CosSin { cos, sin })
}
