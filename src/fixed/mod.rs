//! The laws in integers alone (feature `fixed`): for processors without a floating-point unit.
//!
//! [`Fixed`]`(Ball)` is the law [`Ball`](crate::Ball) in fixed point, with the operations that
//! [`Law`](crate::Law) has for floats under the same names. Its numbers are those of the `fixed` crate:
//!
//! | number | type | from | to | unit |
//! |---|---|---|---|---|
//! | cosine, sine, direction | `I1F31` | −1 + 2⁻³¹ | 1 − 2⁻³¹ | 2⁻³¹ |
//! | probability | `U0F32` | 0 | 1 − 2⁻³² | 2⁻³² |
//! | angle, in turns | `I0F32` | −½ | ½ − 2⁻³² | 2⁻³² |
//! | density, per radian or steradian | `U0F32`; `U16F16` for [`CosPower`] | 0 | 1; 65536 | 2⁻³²; 2⁻¹⁶ |
//! | exponent | `U16F16` | 0 | 65536 − 2⁻¹⁶ | 2⁻¹⁶ |
//!
//! All 32 bits of a word are used by each: an angle in turns wraps where the word does, and no six plain densities exceed
//! 2/π. ±1 **saturates** to ±(1 − 2⁻³¹), so that a component can be negated, and the probability 1 to 1 − 2⁻³².
//! θ lies in \[−¼, ¼\] turn in the plane and \[0, ¼\] in space, both ends exact; outside it the density is 0 and the
//! cdf 0 or 1.
//!
//! [`Fixed16`](crate::Fixed16) has half the bits, for a third of the instructions on a Cortex-M0.
//!
//! # Errors
//!
//! In units of the last place of the result (2⁻³¹ for components, 2⁻³² for probabilities, turns and densities), the
//! larger of an operation and its counterpart from the other end:
//!
//! | | `warp` | unit length | `unwarp` | `density` | `pdf` | `cdf` | `quantile` |
//! |---|---|---|---|---|---|---|---|
//! | `Disk` | 3.5 | 2 | 5 | 2 | 4.5 | 1.5 | 1.75 |
//! | `CircleShell` | 2 | 2 | 1 | 0 | 1.5 | 1.5 | 2 |
//! | `CircleArc` | 2 | 2 | 3 | 0.5 | 0.5 | 0 | 1 |
//! | `Ball` | 2.5 | 2.5 | 5 | 3 | 4.5 | 7 | 2.5 |
//! | `SphereShell` | 3.5 | 3.5 | 4 | 2 | 4 | 6 | 2.5 |
//! | `Lambert` | 1 | 1.5 | 3 | 1.5 | 3 | 5 | 2 |
//! | `CosPower`, k ≤ 7.25 | 2.5 | 2 | | 1.01 · 2⁻¹⁶ | 1.01 · 2⁻¹⁶ | 6 | 2 |
//! | `CosPower`, k < 65536 | 2.5 | 2 | | 30 · 2⁻¹⁶ | 1.5 · 2⁻¹⁶ | 180 | 2 |
//!
//! `tests/fixed` asserts these bounds. `warp` was tried on **every** word; its worst components and lengths:
//!
//! | | component | at | length | at |
//! |---|---|---|---|---|
//! | `Disk` | 3.143 | 0x7fdc3a9c | 1.910 | 0x16e55b45 |
//! | `CircleShell` | 1.598 | 0x73735d86 | 1.592 | 0x764b06ed |
//! | `CircleArc` | 1.515 | 0x40043f83 | 1.910 | 0x3fa352ba |
//! | `Ball` | 2.482 | 0xbf6064b5 | 2.417 | 0xff9d89d2 |
//! | `SphereShell` | 3.228 | 0xc9016ed4 | 3.021 | 0xff0b3c90 |
//! | `Lambert` | 1.000 | 0x00000000 | 1.131 | 0x7b0fe247 |
//!
//! In the other cells 7·10⁷ words (10⁵ for `CosPower`) and the corners lie within the bounds. `unwarp`
//! and `density` are judged at a pair rounded to its format.
//!
//! # Words of randomness
//!
//! [`Fixed::sample`] takes words by `next_u32`, always as many, and no rejection:
//!
//! | law | words | cos θ |
//! |---|---|---|
//! | `Lambert`, `SphereShell`, `Ball` | 2, 3, 4 for θ, then 1 for the azimuth | their maximum |
//! | `CosPower` | 2, then 1 | u^(1/(k+1)), u of 64 bits |
//! | `Disk` | 3 | ∛(2p) is their maximum, p the nearer tail |
//! | `CircleShell` | 2 | √(v (2 − v)), v of 64 bits |
//! | `CircleArc` | 1 | of ± that many quarter turns |
//!
//! U^(1/n) is the largest of n uniform numbers: so no root is taken of a word, and cos θ is as fine as its format, down
//! to 2⁻³¹ (for `Ball` that has probability 2⁻¹²⁴). Beside the axis 1 − cos θ continues with the bits of the words that lost, to
//! 2⁻⁶⁴. Whatever the generator gives, cos θ > 0 and the direction has unit length to 4 units.
//!
//! # Cost
//!
//! Instructions of one `sample`, Marsaglia's xorshift32 included / PCG32 included, bytes of flash with the former, bytes
//! of stack (Rust 1.95, `opt-level = 3`; `python3 tools/fixed_cost.py` counts all operations):
//!
//! | | Cortex-M0 | flash | stack | Cortex-M3 | Cortex-M4F |
//! |---|---|---|---|---|---|
//! | `Lambert` | 514 / 665 | 1148 | 64 | 176 / 209 | 173 / 223 |
//! | `SphereShell` | 525 / 716 | 1172 | 64 | 182 / 225 | 179 / 226 |
//! | `Ball` | 537 / 773 | 1208 | 64 | 188 / 248 | 185 / 250 |
//! | `CosPower` | 1111 / 1250 | 2532 | 96 | 339 / 382 | 321 / 367 |
//! | `Disk` | 539 / 691 | 708 | 80 | 148 / 182 | 137 / 182 |
//! | `CircleShell` | 234 / 329 | 556 | 48 | 99 / 118 | 99 / 133 |
//! | `CircleArc` | 231 / 280 | 508 | 52 | 70 / 85 | 72 / 87 |
//!
//! Maxima are cheaper than roots too: `warp`'s roots of one word, θ alone, cost 329, 649 and 576 instructions on Cortex-M0 for
//! `Lambert`, `SphereShell` and `Ball`; a whole sample with its azimuth and xorshift32 costs 514, 526 and 535. The 64-bit
//! product, one instruction on the larger cores, is four products on Cortex-M0, with the same bits. The largest stack of
//! any operation on any of the three is 160 bytes.
//!
//! ```
//! use coslobe::{Fixed, Lambert};
//! use fixed::types::{I1F31, U0F32};
//! let mut rng = rand_pcg::Pcg32::new(1, 1);
//! let [x, y, z]: [I1F31; 3] = Fixed(Lambert).sample(&mut rng); // [sin θ cos φ, cos θ, sin θ sin φ]
//! assert!(y > 0);
//! let at = Fixed(Lambert).warp(U0F32::from_num(0.25));
//! assert!((at.sin.to_num::<f32>() - 0.5).abs() < 1e-9);
//! # let _ = (x, z);
//! ```
//!
mod ball;
mod circle_arc;
mod circle_shell;
mod cos_power;
mod disk;
pub(crate) mod format;
pub(crate) mod kernel;
mod lambert;
pub(crate) mod law;
mod planar;
mod q31;
mod spatial;
mod sphere_shell;
pub(crate) mod words;

pub use cos_power::CosPower;
pub use law::FixedLaw;

use crate::CosSin;
use ::fixed::types::{I0F32, I1F31, U0F32};
use law::Tails;
use rand_core::Rng;

/// A law in fixed point: see the [module](self) for its numbers, errors and costs.
///
/// Meaning and formulas are those of the law inside. No floating-point instruction or routine is linked, no division, no table; no
/// operation overflows or panics for any word.
///
/// ```
/// use coslobe::fixed::CosPower;
/// use coslobe::{Disk, Fixed};
/// use fixed::types::{I0F32, U0F32, U16F16};
/// let half = U0F32::from_num(0.5);
/// assert!(Fixed(Disk).quantile(half).to_bits().abs() <= 1); // the median is the axis, to a unit
/// assert_eq!(Fixed(Disk).cdf(I0F32::from_num(-0.25)), 0);
/// let lobe = Fixed(CosPower::new(U16F16::from_num(64)));
/// assert!((lobe.pdf(I0F32::ZERO), lobe.density(lobe.warp(U0F32::ZERO)).to_num::<f32>()) > (U16F16::ZERO, 10.3));
/// ```
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
    /// (cos θ, sin θ) at cdf = `u`: a unit vector to 4 units, cos θ ≥ 0.
    #[inline]
    pub fn warp(&self, u: U0F32) -> CosSin<I1F31> {
        of_bits(self.0.pair(Tails::from_lower(u.to_bits())))
    }

    /// (cos θ, sin θ) at sf = `q`: [`warp`](Fixed::warp) entered from the other end, which reaches the horizon by
    /// itself, not by 1 − u.
    #[inline]
    pub fn warp_sf(&self, q: U0F32) -> CosSin<I1F31> {
        of_bits(self.0.pair(Tails::from_upper(q.to_bits())))
    }

    /// cdf at a direction: the inverse of [`warp`](Fixed::warp).
    ///
    /// Reads the smaller of cos θ and sin θ; any pair is safe, no value is promised for one that is no unit vector.
    #[inline]
    pub fn unwarp(&self, at: CosSin<I1F31>) -> U0F32 {
        U0F32::from_bits(self.0.tails(bits(at)).lower)
    }

    /// sf at a direction: the inverse of [`warp_sf`](Fixed::warp_sf).
    #[inline]
    pub fn unwarp_sf(&self, at: CosSin<I1F31>) -> U0F32 {
        U0F32::from_bits(self.0.tails(bits(at)).upper)
    }

    /// Density of a direction: rad⁻¹ in the plane, sr⁻¹ in space.
    ///
    /// 0 below the horizon (cos θ < 0) and, in space, for sin θ < 0. For cos θ > 0 it is never 0, but at least one unit, so that a
    /// weight can be divided by it. Reads cos θ alone ([`CosPower`]: the smaller of cos θ and sin θ).
    #[inline]
    pub fn density(&self, at: CosSin<I1F31>) -> L::Density {
        self.0.density(bits(at))
    }

    /// Density of θ in turns: **per radian** in the plane, per dθ dφ in radians in space (the paper's q).
    #[inline]
    pub fn pdf(&self, theta: I0F32) -> L::Density {
        self.0.pdf(theta.to_bits())
    }

    /// P(Θ ≤ θ), azimuth integrated out; θ in turns.
    #[inline]
    pub fn cdf(&self, theta: I0F32) -> U0F32 {
        U0F32::from_bits(self.0.tails_at(theta.to_bits()).lower)
    }

    /// P(Θ > θ) = 1 − cdf, computed by itself.
    #[inline]
    pub fn sf(&self, theta: I0F32) -> U0F32 {
        U0F32::from_bits(self.0.tails_at(theta.to_bits()).upper)
    }

    /// θ in turns at cdf = `p`, in the support.
    #[inline]
    pub fn quantile(&self, p: U0F32) -> I0F32 {
        I0F32::from_bits(self.0.turn(Tails::from_lower(p.to_bits())))
    }

    /// θ in turns at sf = `p`, in the support.
    #[inline]
    pub fn isf(&self, p: U0F32) -> I0F32 {
        I0F32::from_bits(self.0.turn(Tails::from_upper(p.to_bits())))
    }

    /// Draws \[sin θ, cos θ\] in the plane, \[sin θ cos φ, cos θ, sin θ sin φ\] in space: a unit vector to 4 units, cos θ > 0.
    ///
    /// Randomness: the words of the table in the [module](self), each by `next_u32`.
    #[inline]
    pub fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> L::Direction {
        self.0.draw(rng)
    }
}

/// (cos, sin) of an angle in turns, to 1.4975 units of 2⁻³¹ (exhaustive, worst word 0x60003fa5); ±1 saturates.
///
/// 226 instructions on Cortex-M0, 68 on Cortex-M4F.
#[inline]
pub fn cos_sin(turn: I0F32) -> CosSin<I1F31> {
    let (cos, sin) = kernel::turn::cos_sin(turn.to_bits() as u32);
    of_bits(CosSin { cos, sin })
}
