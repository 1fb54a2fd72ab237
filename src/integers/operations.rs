//! A law in integers: the operations, from numbers to words and back, once for both formats.

use super::format::{Format, Turn};
use super::law::Formulas;
use super::q15::Q15;
use super::q31::Q31;
use super::tails::Tails;
use crate::{CosSin, Sample};
use ::fixed::types::U16F16;
use core::fmt;
use core::marker::PhantomData;
use rand_core::{Rng, TryRng};

/// The law `L` in integers of the format `F`: [`Fixed`](type@Fixed) or [`Fixed16`](type@Fixed16).
///
/// Meaning and formulas are those of the law inside; numbers, errors and costs stand in the
/// [module](super). No floating-point instruction or routine is linked, no division, no table; no
/// operation overflows or panics for any word.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        transparent,
        bound(
            serialize = "L: serde::Serialize",
            deserialize = "L: serde::Deserialize<'de>"
        )
    )
)]
pub struct Integers<F, L>(pub L, PhantomData<F>);

/// A law in fixed point of 32 bits: see the [module](super) for its numbers, errors and costs.
///
/// ```
/// use coslobe::integers::CosPower;
/// use coslobe::{Disk, Fixed};
/// use fixed::types::{I0F32, U0F32, U16F16};
/// let half = U0F32::from_num(0.5);
/// assert!(Fixed(Disk).quantile(half).to_bits().abs() <= 1); // the median is the axis, to a unit
/// assert_eq!(Fixed(Disk).cdf(I0F32::from_num(-0.25)), 0);
/// let lobe = Fixed(CosPower::new(U16F16::from_num(64)));
/// let on_axis = lobe.density(lobe.warp(U0F32::ZERO));
/// assert!(lobe.pdf(I0F32::ZERO) == 0 && on_axis > U16F16::from_num(10.3));
/// ```
pub type Fixed<L> = Integers<Q31, L>;

/// A law in fixed point of 16 bits: see the [module](super) for its numbers, errors and costs.
///
/// ```
/// use coslobe::{Disk, Fixed16};
/// use fixed::types::{I0F16, U0F16};
/// let half = U0F16::from_num(0.5);
/// assert!(Fixed16(Disk).quantile(half).to_bits().abs() <= 1); // the median is the axis, to a unit
/// assert_eq!(Fixed16(Disk).cdf(I0F16::from_num(-0.25)), 0);
/// ```
pub type Fixed16<L> = Integers<Q15, L>;

// Named as the types, since an alias is no constructor.

/// `law` in fixed point of 32 bits.
#[allow(non_snake_case)]
#[inline]
pub const fn Fixed<L: Formulas<Q31>>(law: L) -> Fixed<L> {
    Integers(law, PhantomData)
}

/// `law` in fixed point of 16 bits.
#[allow(non_snake_case)]
#[inline]
pub const fn Fixed16<L: Formulas<Q15>>(law: L) -> Fixed16<L> {
    Integers(law, PhantomData)
}

#[inline(always)]
pub(super) fn lower<F: Format>(p: F::Probability) -> Tails {
    Tails::from_lower(F::of_probability(p))
}

#[inline(always)]
fn upper<F: Format>(q: F::Probability) -> Tails {
    Tails::from_upper(F::of_probability(q))
}

#[inline(always)]
pub(super) fn words<F: Format>(at: CosSin<F::Component>) -> CosSin<i32> {
    CosSin {
        cos: F::of_component(at.cos),
        sin: F::of_component(at.sin),
    }
}

#[inline(always)]
pub(super) fn of_words<F: Format>(at: CosSin<i32>) -> CosSin<F::Component> {
    CosSin {
        cos: F::component(at.cos),
        sin: F::component(at.sin),
    }
}

impl<F: Format, L: Formulas<F>> Integers<F, L> {
    /// (cos θ, sin θ) at cdf = `u`: a unit vector to 4 units (`Fixed16`: 2), cos θ ≥ 0.
    #[inline]
    pub fn warp(&self, u: F::Probability) -> CosSin<F::Component> {
        of_words::<F>(self.0.warp_tails(lower::<F>(u)))
    }

    /// (cos θ, sin θ) at sf = `q`: [`warp`](Self::warp) entered from the other end, which reaches
    /// the horizon by itself, not by 1 − u.
    #[inline]
    pub fn warp_sf(&self, q: F::Probability) -> CosSin<F::Component> {
        of_words::<F>(self.0.warp_tails(upper::<F>(q)))
    }

    /// cdf at a direction: the inverse of [`warp`](Self::warp).
    ///
    /// Reads the smaller of cos θ and sin θ; any pair is safe, no value is promised for one that
    /// is no unit vector.
    #[inline]
    pub fn unwarp(&self, at: CosSin<F::Component>) -> F::Probability {
        F::probability(self.0.unwarp_tails(words::<F>(at)).lower)
    }

    /// sf at a direction: the inverse of [`warp_sf`](Self::warp_sf).
    #[inline]
    pub fn unwarp_sf(&self, at: CosSin<F::Component>) -> F::Probability {
        F::probability(self.0.unwarp_tails(words::<F>(at)).upper)
    }

    /// Density of a direction: rad⁻¹ in the plane, sr⁻¹ in space.
    ///
    /// 0 below the horizon (cos θ < 0) and, in space, for sin θ < 0. For cos θ > 0 it is never 0,
    /// but at least one unit, so that a weight can be divided by it. Reads cos θ alone
    /// ([`CosPower`](super::CosPower): the smaller of cos θ and sin θ).
    #[inline]
    pub fn density(&self, at: CosSin<F::Component>) -> L::Density {
        self.0.density(words::<F>(at))
    }

    /// Lambert's reflected radiance over this law's density: the weight f·cos/p of a sample, for a
    /// white diffuse surface, as [`Law::lambert_weight`](crate::Law::lambert_weight) of floats.
    ///
    /// In both formats a `U16F16`, since it may be large where the law is rare: what exceeds 65536
    /// − 2⁻¹⁶, and the ∞ at cos θ = 0 of a law with k > 1, **saturates** to that. 0 outside the
    /// support. Reads what [`density`](Self::density) reads; errors stand in the
    /// [module](super).
    #[inline]
    pub fn lambert_weight(&self, at: CosSin<F::Component>) -> U16F16 {
        self.0.lambert_weight(words::<F>(at))
    }

    /// Density of θ in turns: **per radian** in the plane, per dθ dφ in radians in space (the
    /// paper's q).
    #[inline]
    pub fn pdf(&self, theta: F::Turn) -> L::Density {
        self.0.pdf(F::of_turn(theta))
    }

    /// P(Θ ≤ θ), azimuth integrated out; θ in turns.
    #[inline]
    pub fn cdf(&self, theta: F::Turn) -> F::Probability {
        F::probability(self.0.tails(F::of_turn(theta)).lower)
    }

    /// P(Θ > θ) = 1 − cdf, computed by itself.
    #[inline]
    pub fn sf(&self, theta: F::Turn) -> F::Probability {
        F::probability(self.0.tails(F::of_turn(theta)).upper)
    }

    /// θ in turns at cdf = `p`, in the support.
    #[inline]
    pub fn quantile(&self, p: F::Probability) -> F::Turn {
        F::turn(self.0.quantile_tails(lower::<F>(p)))
    }

    /// θ in turns at sf = `p`, in the support.
    #[inline]
    pub fn isf(&self, p: F::Probability) -> F::Turn {
        F::turn(self.0.quantile_tails(upper::<F>(p)))
    }

    /// Draws \[sin θ, cos θ\] in the plane, \[sin θ cos φ, cos θ, sin θ sin φ\] in space: a unit
    /// vector to 4 units (`Fixed16`: 2), cos θ > 0.
    ///
    /// Randomness: the words of the table in the [module](super), each by `next_u32`.
    #[inline]
    pub fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        let Ok(drawn) = self.0.try_draw(rng);
        drawn.direction
    }

    /// [`sample`](Self::sample) with a generator that can fail: the same words in the same order.
    ///
    /// # Errors
    /// The generator's first error, handed on; no word is drawn after it.
    #[inline]
    pub fn try_sample<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<L::Direction, R::Error> {
        Ok(self.0.try_draw(rng)?.direction)
    }
}

impl<F: Format, L, const N: usize> Integers<F, L>
where
    L: Formulas<F, Direction = [<F as Format>::Component; N]>,
{
    /// Draws the direction of [`sample`](Self::sample) with its cosine, sine and density: the same
    /// words, the same bits.
    #[inline]
    pub fn sample_with_density<R: Rng + ?Sized>(
        &self,
        rng: &mut R,
    ) -> Sample<F::Component, N, L::Density> {
        let Ok(drawn) = self.0.try_draw(rng);
        let at = of_words::<F>(drawn.at);
        Sample {
            direction: drawn.direction,
            at,
            density: self.density(at),
        }
    }
}

impl<F: Format, L: fmt::Debug> fmt::Debug for Integers<F, L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple(F::NAME).field(&self.0).finish()
    }
}

#[cfg(feature = "defmt")]
impl<F: Format, L: defmt::Format> defmt::Format for Integers<F, L> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=str}({})", F::NAME, self.0);
    }
}

/// (cos, sin) of an angle in turns, ±1 saturated: to 1.4975 units of 2⁻³¹ (exhaustive, worst word
/// 0x60003fa5) of an `I0F32`, to 1 unit of 2⁻¹⁵ of an `I0F16`.
#[inline]
pub fn cos_sin<T: Turn>(turn: T) -> CosSin<<T::Format as Format>::Component> {
    let (cos, sin) = T::Format::cos_sin(T::Format::of_turn(turn) as u32);
    let [cos, sin] = [cos, sin].map(T::Format::clamped);
    of_words::<T::Format>(CosSin { cos, sin })
}
