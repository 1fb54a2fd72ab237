//! Uniform by area in a disk.

use super::Planar;
use super::formulas::{Formulas, Own, Parameterless, variance};
use super::measure::{Measure, Point};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::law::support::{planar, planar_direction, within};
use crate::number::Real;
use crate::number::tier::{Bits, Code, Margin};
use crate::uniform::TailBits;
use crate::{CosSin, Moments, Tails};
use rand_core::{Rng, TryRng};

/// Direction of a point uniform **by area** in a disk tangent to the origin (paper 3.1).
///
#[doc = include_str!("../../docs/measured/lobes/disk.svg")]
///
/// Operations: [`Law`](crate::Law) and [`Planar`](crate::Planar); the point itself:
/// [`PlanarPoint`](crate::PlanarPoint).
///
/// The point is uniform in the disk of radius ρ about (0, ρ). A ray at θ from +y leaves the disk
/// at r = 2ρ cos θ, so ∫₀^{2ρ cos θ} r dr / (πρ²) gives the density
///
/// > p(θ) = 2 cos²θ / π per radian, θ ∈ \[−π/2, π/2\]
///
/// and cdf ½ + (θ + sin θ cos θ)/π. Its inverse is Kepler's equation at eccentricity 1, solved
/// here with one cube root (or none) and one polynomial: no iteration, no bracket, and no loss of
/// digits in the tails. sin θ follows Wigner's semicircle law.
///
/// Errors: within [`accuracy`](crate::accuracy)'s table, everywhere in the support; outside it the
/// density is 0. Randomness of a sample: one `next_u64` for `f32`, two for `f64`.
/// Costs: beside the errors in [`accuracy`](crate::accuracy), for every number type.
///
/// ```
/// use coslobe::{Disk, Law};
/// let at = Disk.warp(1e-30f64);
/// assert!((at.cos - 1.6765391932197433e-10).abs() < 1e-25); // an angle would have lost this
/// assert!((Disk.unwarp(at) / 1e-30 - 1.0).abs() < 1e-15);
/// ```
///
/// Source: V. Chizhov, *Probability density functions of the normalized disk, circle, ball and
/// sphere*, section 3.1.
#[doc(alias = "normalized disk")]
#[doc(alias = "semicircle")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Disk;

impl Disk {
    /// [`Planar::sample`], callable whatever traits are in scope.
    #[inline]
    pub fn sample<T: Real, R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(self, rng)
    }
}

impl<W: Kernel> Formulas<W> for Disk {
    #[inline(always)]
    fn pdf(&self, theta: W) -> W {
        let c = W::at_angle(theta).cos;
        let p = c.times(c).times(W::CONSTANTS.two_over_pi).value();
        within(theta, planar(theta), p, W::ZERO)
    }

    #[inline(always)]
    fn ln_pdf(&self, theta: W) -> W {
        let p = W::CONSTANTS.ln_two_over_pi.value() + W::ln_cos(W::at_angle(theta)) * W::int(2);
        within(theta, planar(theta), p, -W::INFINITY)
    }

    #[inline(always)]
    fn tails(&self, theta: W) -> Tails<W> {
        let inside = planar(theta);
        let p = within(theta, inside, W::disk_tail_at_angle(theta.abs()), W::ZERO);
        Tails::from_nearer(p, theta > W::ZERO)
    }

    #[inline(always)]
    fn density(&self, at: CosSin<W>) -> W {
        let c2 = at.cos * at.cos;
        let p = c2 * W::CONSTANTS.two_over_pi.value();
        planar_direction(at, p)
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W> {
        let (p, is_lower) = p.nearer();
        let CosSin { cos, sin } = W::disk_direction_at_tail(p);
        CosSin {
            cos,
            sin: sin.negate_if_odd(is_lower),
        }
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W> {
        let p = W::disk_tail_at_direction(at.cos, at.sin.abs());
        Tails::from_nearer(planar_direction(at, p), at.sin > W::ZERO)
    }

    #[inline(always)]
    fn quantile_tails(&self, p: Tails<W>) -> W {
        let (p, is_lower) = p.nearer();
        W::disk_angle_at_tail(p).negate_if_odd(is_lower)
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<W>) -> W {
        planar_direction(at, W::CONSTANTS.pi.value() * W::QUARTER / at.cos.abs())
    }
}

impl Own for Disk {}

impl Parameterless for Disk {
    fn moments<B: Native>() -> Moments<Pair<B>> {
        let c = <B as Native>::CONSTANTS;
        let mean_cos = c.recip_pi.mul(Pair::ratio(8, 3));
        Moments {
            mean_cos,
            var_cos: variance(Pair::ratio(3, 4), mean_cos),
            mean_theta: Pair::from_value(B::ZERO),
            var_theta: c
                .pi
                .mul(c.pi)
                .mul(Pair::ratio(1, 12))
                .add(Pair::ratio(-1, 2)),
            entropy: c.ln_two_pi.add(Pair::ratio(-1, 1)),
        }
    }
}

impl Point for Disk {
    const MEASURE: Measure = Measure::Area;
    const IS_PLANAR: bool = true;
    const IS_SOLID: bool = true;

    #[inline]
    fn share<W: Kernel>(v: W) -> W {
        v.sqrt()
    }

    /// 1/(πρ²).
    #[inline]
    fn point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        let recip_pi = W::CONSTANTS.recip_pi.value();
        recip_pi / rho * (W::ONE / rho)
    }

    #[inline]
    fn ln_point_density<W: Kernel>(rho: W, _: CosSin<W>) -> W {
        -(W::CONSTANTS.ln_pi.value() + rho.ln() * W::int(2))
    }
}

/// The shadow of a direction of [`Lambert`](crate::Lambert)'s law on a plane through the normal: no
/// equation is solved.
///
/// The shadows of Lambert's directions fill a disk evenly, so that sin θ = √u cos φ. Of u the other
/// tail 1 − u is known too, from which cos²θ = (1 − u) + u sin²φ has all digits at both ends.
impl<T: Real> Planar<T> for Disk {
    #[inline(always)]
    fn try_draw_theta<R: TryRng + ?Sized>(&self, rng: &mut R) -> Result<TailBits<T>, R::Error> {
        T::try_draw_pair_bits(rng)
    }

    #[inline(always)]
    fn sample_by(&self, bits: TailBits<T>, code: Code) -> [T; 2] {
        let (u, phi) = bits.split();
        let u = T::tails_from_half(<TailBits<T> as Bits>::in_order(u), code);
        T::rounded(
            Margin::Relative,
            #[inline(always)]
            || shadow(Holds::from_tails(u), T::quick_turn_from_bits(phi, code)),
            #[inline(always)]
            || shadow(Holds::from_tails(u), T::accurate_turn_from_bits(phi, code)),
        )
    }
}

/// [sin θ, cos θ] of a point of the disk: the tails of its squared distance from the centre, and
/// its azimuth.
#[inline(always)]
fn shadow<W: Kernel>(u: Tails<W>, phi: CosSin<W>) -> [W; 2] {
    // The sign of a square is not worked out.
    let sin = phi.sin.abs();
    let cos_squared = u.upper() + u.lower() * (sin * sin);
    [u.lower().sqrt() * phi.cos, cos_squared.sqrt()]
}
