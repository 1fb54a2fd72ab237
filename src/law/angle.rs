//! What every law can tell of the angle from its axis, one at a time and in slices.

use crate::batch::{self, Batch, LengthError};
use crate::law::direction::{Azimuth, angle, spherical, turn};
use crate::law::support::into_support;
use crate::number::Real;
use crate::{CosSin, Moments, Tails};

/// What every law can tell of the angle θ from the axis +y, in radians.
///
/// Support: \[−π/2, π/2\] for [`Planar`](crate::Planar) laws, \[0, π/2\] for
/// [`Spatial`](crate::Spatial) ones, with the true π: `f32`'s `FRAC_PI_2` lies beyond it. All
/// functions are total: NaN gives NaN; outside the support the density is 0, its logarithm −∞ and
/// the cdf 0 or 1; a probability outside \[0, 1\] gives NaN. No input panics. The accuracy of each
/// is in [`accuracy`](crate::accuracy).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law in the number type `{T}`",
    label = "no law of a direction in `{T}`",
    note = "in integers a law is inside `Fixed` or `Fixed16`; `coslobe::integers::CosPower` is a \
            law there alone, and `coslobe::CosPower` that of floats"
)]
pub trait Law<T: Real> {
    /// Density of θ: per radian for planar laws; for spatial ones per dθ dφ (the paper's q),
    /// that is [`pdf_solid_angle`](crate::Spatial::pdf_solid_angle) times sin θ.
    fn pdf(&self, theta: T) -> T;

    /// ln [`pdf`](Law::pdf), finite where `pdf` would underflow; −∞ where it is 0.
    fn ln_pdf(&self, theta: T) -> T;

    /// (cdf, sf) of θ, azimuth integrated out, each to full relative accuracy.
    fn tails(&self, theta: T) -> Tails<T>;

    /// Density of a direction with no trigonometry: rad⁻¹ in 2D, sr⁻¹ in 3D. Reads cos θ alone
    /// (`CosPower`: the smaller of cos θ and sin θ). 0 below the horizon (cos θ < 0) and, in 3D,
    /// for sin θ < 0.
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
    /// k = 3 (`Ball`) on, since E\[w²\] ∝ ∫ cos²⁻ᵏθ d(cos θ) diverges; combine such a law with
    /// another through [`balance_heuristic`](crate::balance_heuristic). 2D: k < 3 is finite.
    fn lambert_weight(&self, at: CosSin<T>) -> T;

    /// Exact mean and variance of cos θ and of θ, and the differential entropy.
    fn moments(&self) -> Moments<T>;

    /// \[sin θ cos φ, cos θ, sin θ sin φ\] at the given tails of θ; of this crate's laws each is
    /// rounded once.
    #[doc(hidden)]
    #[inline(always)]
    fn warp_spherical(&self, p: Tails<T>, azimuth: Azimuth<T>) -> [T; 3] {
        spherical(self.warp_tails(p), azimuth.rounded())
    }

    /// \[cdf of θ, azimuth in turns\] of a direction; of this crate's laws each is rounded once.
    #[doc(hidden)]
    #[inline]
    fn unwarp_spherical(&self, d: [T; 3]) -> [T; 2] {
        let sin = CosSin::hypot(d[0], d[2]);
        [self.unwarp(CosSin { cos: d[1], sin }), turn(d)]
    }

    /// θ at the given tails, never outside the support.
    #[inline]
    fn quantile_tails(&self, p: Tails<T>) -> T {
        into_support(angle(self.warp_tails(p)))
    }

    /// P(Θ ≤ θ), azimuth integrated out. Keeps its relative accuracy towards 0.
    ///
    /// Between neighbouring θ it may step back by up to 4 ulp, in `Precise` never.
    #[inline]
    fn cdf(&self, theta: T) -> T {
        self.tails(theta).lower()
    }

    /// P(Θ > θ) = 1 − cdf, with its own relative accuracy towards 0; steps back as `cdf`.
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

    /// (cos θ, sin θ) at sf = `q`.
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

    /// [`pdf`](Law::pdf) of each θ.
    ///
    /// Every `…_slice` gives the bits of as many scalar calls, however wide the vectors: [`batch`].
    ///
    /// # Errors
    /// If the slices have unequal lengths; then nothing is written. So with every `…_slice`.
    fn pdf_slice(&self, theta: &[T], out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            theta,
            [out],
            #[inline(always)]
            |x| [self.pdf(x)],
        )
    }

    /// [`ln_pdf`](Law::ln_pdf) of each θ.
    fn ln_pdf_slice(&self, theta: &[T], out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            theta,
            [out],
            #[inline(always)]
            |x| [self.ln_pdf(x)],
        )
    }

    /// [`cdf`](Law::cdf) of each θ.
    fn cdf_slice(&self, theta: &[T], out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            theta,
            [out],
            #[inline(always)]
            |x| [self.tails(x).lower()],
        )
    }

    /// [`sf`](Law::sf) of each θ.
    fn sf_slice(&self, theta: &[T], out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            theta,
            [out],
            #[inline(always)]
            |x| [self.tails(x).upper()],
        )
    }

    /// [`quantile`](Law::quantile) of each probability.
    fn quantile_slice(&self, p: &[T], out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            p,
            [out],
            #[inline(always)]
            |x| [self.quantile_tails(Tails::from_lower(x))],
        )
    }

    /// [`isf`](Law::isf) of each probability.
    fn isf_slice(&self, p: &[T], out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            p,
            [out],
            #[inline(always)]
            |x| [self.quantile_tails(Tails::from_upper(x))],
        )
    }

    /// [`warp`](Law::warp) of each probability.
    ///
    /// ```
    /// use coslobe::{CosSin, Lambert, Law};
    /// let u = [0.0, 0.25, 1.0f32];
    /// let (mut cos, mut sin) = ([0.0; 3], [0.0; 3]);
    /// Lambert.warp_slice(&u, CosSin { cos: &mut cos, sin: &mut sin })?;
    /// assert_eq!(sin, [0.0, 0.5, 1.0]);
    /// # Ok::<(), coslobe::LengthError>(())
    /// ```
    fn warp_slice(&self, u: &[T], out: CosSin<&mut [T]>) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            u,
            [out.cos, out.sin],
            #[inline(always)]
            |u| self.warp_tails(Tails::from_lower(u)).to_array(),
        )
    }

    /// [`density`](Law::density) of each direction.
    fn density_slice(&self, at: CosSin<&[T]>, out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            (at.cos, at.sin),
            [out],
            #[inline(always)]
            |(cos, sin)| [self.density(CosSin { cos, sin })],
        )
    }

    /// [`unwarp`](Law::unwarp) of each direction.
    fn unwarp_slice(&self, at: CosSin<&[T]>, out: &mut [T]) -> Result<(), LengthError>
    where
        T: Batch,
    {
        batch::map(
            (at.cos, at.sin),
            [out],
            #[inline(always)]
            |(cos, sin)| [self.unwarp_tails(CosSin { cos, sin }).lower()],
        )
    }
}
