//! The operations, from numbers to words and back.

use super::format::Q15;
use super::kernel;
use crate::CosSin;
use crate::fixed::format::Format;
use crate::fixed::law::{Tails, Words};
use ::fixed::types::{I0F16, I1F15, U0F16};
use rand_core::Rng;

/// The laws that [`Fixed16`] knows. Sealed.
pub trait Fixed16Law: Words<Q15, Density = U0F16> {}

impl<L: Words<Q15, Density = U0F16>> Fixed16Law for L {}

/// A law in fixed point of 16 bits: see the [module](super) for its numbers, errors and costs.
///
/// Meaning and formulas are those of the law inside. No floating-point instruction or routine is linked, no 64-bit product, no
/// division, no table; no operation overflows or panics for any word.
///
/// ```
/// use coslobe::{Disk, Fixed16};
/// use fixed::types::{I0F16, U0F16};
/// let half = U0F16::from_num(0.5);
/// assert!(Fixed16(Disk).quantile(half).to_bits().abs() <= 1); // the median is the axis, to a unit
/// assert_eq!(Fixed16(Disk).cdf(I0F16::from_num(-0.25)), 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fixed16<L>(pub L);

#[inline(always)]
fn lower(p: U0F16) -> Tails {
    Tails::from_lower(Q15::of_probability(p))
}

#[inline(always)]
fn upper(q: U0F16) -> Tails {
    Tails::from_upper(Q15::of_probability(q))
}

#[inline(always)]
fn word(at: CosSin<I1F15>) -> CosSin<i32> {
    CosSin {
        cos: Q15::of_component(at.cos),
        sin: Q15::of_component(at.sin),
    }
}

#[inline(always)]
fn of_word(at: CosSin<i32>) -> CosSin<I1F15> {
    CosSin {
        cos: Q15::component(at.cos),
        sin: Q15::component(at.sin),
    }
}

impl<L: Fixed16Law> Fixed16<L> {
    /// (cos θ, sin θ) at cdf = `u`: a unit vector to 2 units, cos θ ≥ 0.
    #[inline]
    pub fn warp(&self, u: U0F16) -> CosSin<I1F15> {
        of_word(self.0.pair(lower(u)))
    }

    /// (cos θ, sin θ) at sf = `q`: [`warp`](Fixed16::warp) entered from the other end, which reaches the horizon by
    /// itself, not by 1 − u.
    #[inline]
    pub fn warp_sf(&self, q: U0F16) -> CosSin<I1F15> {
        of_word(self.0.pair(upper(q)))
    }

    /// cdf at a direction: the inverse of [`warp`](Fixed16::warp).
    ///
    /// Reads the smaller of cos θ and sin θ; any pair is safe, no value is promised for one that is no unit vector.
    #[inline]
    pub fn unwarp(&self, at: CosSin<I1F15>) -> U0F16 {
        Q15::probability(self.0.tails(word(at)).lower)
    }

    /// sf at a direction: the inverse of [`warp_sf`](Fixed16::warp_sf).
    #[inline]
    pub fn unwarp_sf(&self, at: CosSin<I1F15>) -> U0F16 {
        Q15::probability(self.0.tails(word(at)).upper)
    }

    /// Density of a direction: rad⁻¹ in the plane, sr⁻¹ in space.
    ///
    /// 0 below the horizon (cos θ < 0) and, in space, for sin θ < 0. For cos θ > 0 it is never 0, but at least one unit, so that a
    /// weight can be divided by it. Reads cos θ alone.
    #[inline]
    pub fn density(&self, at: CosSin<I1F15>) -> U0F16 {
        self.0.density(word(at))
    }

    /// Density of θ in turns: **per radian** in the plane, per dθ dφ in radians in space (the paper's q).
    #[inline]
    pub fn pdf(&self, theta: I0F16) -> U0F16 {
        self.0.pdf(Q15::of_turn(theta))
    }

    /// P(Θ ≤ θ), azimuth integrated out; θ in turns.
    #[inline]
    pub fn cdf(&self, theta: I0F16) -> U0F16 {
        Q15::probability(self.0.tails_at(Q15::of_turn(theta)).lower)
    }

    /// P(Θ > θ) = 1 − cdf, computed by itself.
    #[inline]
    pub fn sf(&self, theta: I0F16) -> U0F16 {
        Q15::probability(self.0.tails_at(Q15::of_turn(theta)).upper)
    }

    /// θ in turns at cdf = `p`, in the support.
    #[inline]
    pub fn quantile(&self, p: U0F16) -> I0F16 {
        Q15::turn(self.0.turn(lower(p)))
    }

    /// θ in turns at sf = `p`, in the support.
    #[inline]
    pub fn isf(&self, p: U0F16) -> I0F16 {
        Q15::turn(self.0.turn(upper(p)))
    }

    /// Draws \[sin θ, cos θ\] in the plane, \[sin θ cos φ, cos θ, sin θ sin φ\] in space: a unit vector to 2 units, cos θ > 0.
    ///
    /// Randomness: the words of the table in the [module](super), each by `next_u32`.
    #[inline]
    pub fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        self.0.draw(rng)
    }
}

/// (cos, sin) of an angle in turns, ±1 saturated.
#[inline]
pub fn cos_sin(turn: I0F16) -> CosSin<I1F15> {
    let (cos, sin) = Q15::cos_sin(Q15::of_turn(turn) as u32);
    let [cos, sin] = [cos, sin].map(|x| x.clamp(-(kernel::ONE as i32), kernel::ONE as i32));
    of_word(CosSin { cos, sin })
}
