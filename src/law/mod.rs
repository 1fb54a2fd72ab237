//! The laws, one a file, and what all of them can do.

mod ball;
mod circle_arc;
mod circle_shell;
mod cos_power;
mod disk;
mod formulas;
mod lambert;
mod sphere_shell;
mod support;

pub use ball::Ball;
pub use circle_arc::CircleArc;
pub use circle_shell::CircleShell;
pub use cos_power::{CosPower, ExponentError};
pub use disk::Disk;
pub use lambert::{Lambert, Lambert as SphereArea};
pub use sphere_shell::SphereShell;

use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::law::support::into_support;
use crate::number::Real;
use crate::number::tier::Margin;
use crate::{CosSin, Frame, Moments, Sample, Tails, uniform};
use rand_core::Rng;

/// What every law can tell of the angle θ from the axis +y, in radians.
///
/// Support: \[−π/2, π/2\] for [`Planar`] laws, \[0, π/2\] for [`Spatial`] ones, with the true π:
/// `f32`'s `FRAC_PI_2` lies beyond it. All functions are total: NaN gives NaN; outside the
/// support the density is 0, its logarithm −∞ and the cdf 0 or 1; a probability outside
/// \[0, 1\] gives NaN. No input panics. The accuracy of each is in [`accuracy`](crate::accuracy).
pub trait Law<T: Real> {
    /// Density of θ: per radian for planar laws; for spatial ones per dθ dφ (the paper's q),
    /// that is [`Spatial::pdf_solid_angle`] times sin θ.
    fn pdf(&self, theta: T) -> T;

    /// Natural logarithm of [`pdf`](Law::pdf), finite where `pdf` would underflow; −∞ where it is 0.
    fn ln_pdf(&self, theta: T) -> T;

    /// (cdf, sf) of θ, azimuth integrated out, each to full relative accuracy.
    fn tails(&self, theta: T) -> Tails<T>;

    /// Density of a direction with no trigonometry: rad⁻¹ in 2D, sr⁻¹ in 3D. Reads cos θ alone
    /// ([`CosPower`]: the smaller of cos θ and sin θ). 0 below the horizon (cos θ < 0) and, in
    /// 3D, for sin θ < 0.
    fn density(&self, at: CosSin<T>) -> T;

    /// (cos θ, sin θ) at the given tails.
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T>;

    /// The tails at a direction: the inverse of [`warp_tails`](Law::warp_tails).
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T>;

    /// Lambert's reflected radiance over this law's density: the weight f·cos/p of a sample, for
    /// a white diffuse surface. 3D: 2/((k+1) cosᵏ⁻¹θ). 2D: (cos θ/2) over the density.
    ///
    /// In closed form, so that 0/0 cannot arise: at cos θ = 0 it is its limit, ∞ for k > 1.
    /// With a constant sky the estimator has zero variance for k = 1, a bounded weight for
    /// k < 1, an unbounded weight of finite variance for 1 < k < 3, and **infinite variance** from
    /// k = 3 ([`Ball`]) on, since E\[w²\] ∝ ∫ cos²⁻ᵏθ d(cos θ) diverges; combine such a law with
    /// another through [`balance_heuristic`](crate::balance_heuristic). 2D: k < 3 is finite.
    fn lambert_weight(&self, at: CosSin<T>) -> T;

    /// Exact mean and variance of cos θ and of θ, and the differential entropy.
    fn moments(&self) -> Moments<T>;

    /// θ at the given tails, never outside the support.
    #[inline]
    fn quantile_tails(&self, p: Tails<T>) -> T {
        let at = self.warp_tails(p);
        let [theta] = T::rounded(
            Margin::Relative,
            || [T::Quick::angle(Holds::from_components(at))],
            || [T::Accurate::angle(Holds::from_components(at))],
        );
        into_support(theta)
    }

    /// P(Θ ≤ θ), azimuth integrated out. Keeps its relative accuracy towards 0.
    #[inline]
    fn cdf(&self, theta: T) -> T {
        self.tails(theta).lower()
    }

    /// P(Θ > θ) = 1 − cdf, with its own relative accuracy towards 0.
    #[inline]
    fn sf(&self, theta: T) -> T {
        self.tails(theta).upper()
    }

    /// θ at cdf = `p`.
    ///
    /// Beside ±π/2 an angle has no digits left for its distance from there: use
    /// [`warp`](Law::warp), which keeps them in cos θ.
    #[inline]
    fn quantile(&self, p: T) -> T {
        self.quantile_tails(Tails::from_lower(p))
    }

    /// θ at sf = `p`.
    #[inline]
    fn isf(&self, p: T) -> T {
        self.quantile_tails(Tails::from_upper(p))
    }

    /// (cos θ, sin θ) at cdf = `u`, each to full relative accuracy.
    #[inline]
    fn warp(&self, u: T) -> CosSin<T> {
        self.warp_tails(Tails::from_lower(u))
    }

    /// (cos θ, sin θ) at sf = `q`: [`warp`](Law::warp) entered from the other end.
    #[inline]
    fn warp_sf(&self, q: T) -> CosSin<T> {
        self.warp_tails(Tails::from_upper(q))
    }

    /// cdf at a direction: the inverse of [`warp`](Law::warp).
    #[inline]
    fn unwarp(&self, at: CosSin<T>) -> T {
        self.unwarp_tails(at).lower()
    }

    /// sf at a direction: the inverse of [`warp_sf`](Law::warp_sf).
    #[inline]
    fn unwarp_sf(&self, at: CosSin<T>) -> T {
        self.unwarp_tails(at).upper()
    }
}

/// Laws of a direction in the plane.
pub trait Planar<T: Real>: Law<T> {
    /// Draws \[sin θ, cos θ\]: a unit vector with cos θ > 0.
    ///
    /// Randomness: one `next_u64` for `f32`, two for `f64`; no rejection.
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        let CosSin { cos, sin } = self.warp_tails(uniform::tails(rng));
        [sin, cos]
    }

    /// Draws the direction of [`sample`](Planar::sample) with its cosine, sine and density: the
    /// same words, the same bits.
    #[inline]
    fn sample_with_density<R: Rng + ?Sized>(&self, rng: &mut R) -> Sample<T, 2> {
        let at = self.warp_tails(uniform::tails(rng));
        Sample {
            direction: [at.sin, at.cos],
            at,
            density: self.density(at),
        }
    }
}

/// Laws of a direction in space, uniform in azimuth.
pub trait Spatial<T: Real>: Law<T> {
    /// Density per steradian at polar angle θ.
    fn pdf_solid_angle(&self, theta: T) -> T;

    /// Draws \[sin θ cos φ, cos θ, sin θ sin φ\]: a unit vector with cos θ > 0.
    ///
    /// Randomness: one `next_u64` then one `next_u32` for `f32`, three `next_u64` for `f64`; no
    /// rejection.
    #[inline]
    fn sample<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        let at = self.warp_tails(uniform::tails(rng));
        spherical(at, uniform::azimuth(rng))
    }

    /// Draws the direction of [`sample`](Spatial::sample) with its cosine, sine and density: the
    /// same words, the same bits.
    #[inline]
    fn sample_with_density<R: Rng + ?Sized>(&self, rng: &mut R) -> Sample<T, 3> {
        let at = self.warp_tails(uniform::tails(rng));
        Sample {
            direction: spherical(at, uniform::azimuth(rng)),
            at,
            density: self.density(at),
        }
    }

    /// Draws a direction around the unit vector `normal`.
    ///
    /// The rotation rounds: each component, and the cosine of the direction to `normal`, is within
    /// 4 ulp of 1 of that of the direction drawn. A cosine smaller than that its digits and may lose its
    /// sign, so that a direction beside the horizon can come out on the surface or below it: weigh
    /// it by the cosine and density of
    /// [`sample_around_with_density`](Spatial::sample_around_with_density).
    /// Randomness as [`sample`](Spatial::sample).
    ///
    /// ```
    /// # use coslobe::{Lambert, Spatial};
    /// # let mut rng = rand_pcg::Pcg32::new(1, 1);
    /// let d: [f32; 3] = Lambert.sample_around([0.0, 0.0, -1.0], &mut rng);
    /// assert!(d[2] < 0.0);
    /// ```
    #[inline]
    fn sample_around<R: Rng + ?Sized>(&self, normal: [T; 3], rng: &mut R) -> [T; 3] {
        Frame::from_unit(normal).to_world(Spatial::sample(self, rng))
    }

    /// Draws the direction of [`sample_around`](Spatial::sample_around) with the cosine, sine and
    /// density that it was drawn with: the same words, the same bits.
    #[inline]
    fn sample_around_with_density<R: Rng + ?Sized>(
        &self,
        normal: [T; 3],
        rng: &mut R,
    ) -> Sample<T, 3> {
        let frame = Frame::from_unit(normal);
        Spatial::sample_with_density(self, rng).rotated(|d| frame.to_world(d))
    }

    /// The direction at cdf of θ = `u[0]` and azimuth φ = `u[1]` turns: for stratified or
    /// low-discrepancy points. NaN outside \[0, 1\]².
    #[inline]
    fn warp_direction(&self, u: [T; 2]) -> [T; 3] {
        let turn = Tails::from_lower(u[1]).lower();
        let azimuth = if turn.is_nan() {
            CosSin {
                cos: turn,
                sin: turn,
            }
        } else {
            CosSin::from_array(T::rounded(
                Margin::Relative,
                || T::Quick::at_turn(Holds::from_number(turn)).to_array(),
                || T::Accurate::at_turn(Holds::from_number(turn)).to_array(),
            ))
        };
        spherical(self.warp(u[0]), azimuth)
    }

    /// \[cdf of θ, azimuth in turns in \[0, 1)\] of a direction: the inverse of
    /// [`warp_direction`](Spatial::warp_direction).
    #[inline]
    fn unwarp_direction(&self, d: [T; 3]) -> [T; 2] {
        let at = CosSin {
            cos: d[1],
            sin: CosSin::hypot(d[0], d[2]),
        };
        let [turn] = T::rounded(
            Margin::Relative,
            || [turns(Holds::from_number(d[2]), Holds::from_number(d[0]))],
            || {
                [turns::<T::Accurate>(
                    Holds::from_number(d[2]),
                    Holds::from_number(d[0]),
                )]
            },
        );
        let turn = if turn < T::ZERO { turn + T::ONE } else { turn };
        // A negative turn smaller than half an ulp of 1 rounds to 1, which is 0 again.
        let turn = if turn >= T::ONE { T::ZERO } else { turn };
        [self.unwarp(at), turn.abs()]
    }
}

/// The angle of (x, y) in turns, from −½ to ½.
#[inline(always)]
fn turns<W: Kernel>(y: W, x: W) -> W {
    y.atan2(x) * W::CONSTANTS.recip_two_pi.value()
}

/// \[sin θ cos φ, cos θ, sin θ sin φ\].
#[inline(always)]
pub(crate) fn spherical<T: Real>(at: CosSin<T>, azimuth: CosSin<T>) -> [T; 3] {
    [at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin]
}
