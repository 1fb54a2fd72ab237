//! The laws' formulas in a working arithmetic, and how they serve every number type.
//!
//! A law's file writes each formula once, on [`Kernel`]. Here the formulas run in the arithmetic
//! of a number type's tier, and their results are rounded to it.

use super::Law;
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::law::direction::{Azimuth, polar, spherical};
use crate::law::support::into_support;
use crate::number::Real;
use crate::number::tier::Margin;
use crate::{CosSin, Moments, Tails};

/// What [`Law`] promises, in an arithmetic W.
pub trait Formulas<W: Kernel> {
    fn pdf(&self, theta: W) -> W;
    fn ln_pdf(&self, theta: W) -> W;
    fn tails(&self, theta: W) -> Tails<W>;
    fn density(&self, at: CosSin<W>) -> W;
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W>;
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W>;
    fn lambert_weight(&self, at: CosSin<W>) -> W;

    /// As [`density`](Formulas::density), at θ: in the plane that is the pdf.
    #[inline(always)]
    fn density_at(&self, theta: W) -> W {
        self.pdf(theta)
    }

    #[inline(always)]
    fn quantile_tails(&self, p: Tails<W>) -> W {
        W::angle(self.warp_tails(p))
    }
}

/// A law of this crate, for which [`Law`] is implemented below.
///
/// It stands beside [`Phases`] because it has no parameter: when another crate writes
/// `impl<T: Real> Law<T> for Mine`, the compiler must see that the blanket implementation does not
/// cover `Mine`. With `Phases<T>` alone it cannot, and refuses: a third crate might implement
/// `Phases` of a number type of its own for `Mine` (E0119).
pub trait Own {}

/// A law without a parameter, which is the same in every arithmetic.
pub trait Parameterless: Own + Copy {
    /// Exact moments, with digits to spare for one rounding.
    fn moments<B: Native>() -> Moments<Pair<B>>;
}

/// A law in the two phases of a number type.
pub trait Phases<T: Real> {
    type Quick: Formulas<T::Quick>;
    type Accurate: Formulas<T::Accurate>;
    fn quick(&self) -> Self::Quick;
    fn accurate(&self) -> Self::Accurate;
    fn moments(&self) -> Moments<T>;
}

/// The variance of what has this mean and this mean square.
pub(crate) fn variance<B: Native>(mean_square: Pair<B>, mean: Pair<B>) -> Pair<B> {
    mean_square.add(mean.mul(mean).neg())
}

impl<T: Real, L> Phases<T> for L
where
    L: Parameterless + Formulas<T::Quick> + Formulas<T::Accurate>,
{
    type Quick = L;
    type Accurate = L;

    #[inline(always)]
    fn quick(&self) -> L {
        *self
    }

    #[inline(always)]
    fn accurate(&self) -> L {
        *self
    }

    #[inline]
    fn moments(&self) -> Moments<T> {
        L::moments::<T::Base>().map(|x| T::from_base(x.value()))
    }
}

impl<T: Real, L: Own + Phases<T>> Law<T> for L {
    #[inline(always)]
    fn pdf(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            #[inline(always)]
            || [self.quick().pdf(Holds::from_number(theta))],
            #[inline(always)]
            || [self.accurate().pdf(Holds::from_number(theta))],
        );
        p
    }

    #[inline(always)]
    fn ln_pdf(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::OfOne,
            #[inline(always)]
            || [self.quick().ln_pdf(Holds::from_number(theta))],
            #[inline(always)]
            || [self.accurate().ln_pdf(Holds::from_number(theta))],
        );
        p
    }

    #[inline(always)]
    fn tails(&self, theta: T) -> Tails<T> {
        Tails::from_array(T::rounded(
            Margin::Relative,
            #[inline(always)]
            || self.quick().tails(Holds::from_number(theta)).to_array(),
            #[inline(always)]
            || self.accurate().tails(Holds::from_number(theta)).to_array(),
        ))
    }

    #[inline(always)]
    fn density(&self, at: CosSin<T>) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            #[inline(always)]
            || [self.quick().density(Holds::from_components(at))],
            #[inline(always)]
            || [self.accurate().density(Holds::from_components(at))],
        );
        p
    }

    #[inline(always)]
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        CosSin::from_array(T::rounded(
            Margin::Relative,
            #[inline(always)]
            || self.quick().warp_tails(Holds::from_tails(p)).to_array(),
            #[inline(always)]
            || self.accurate().warp_tails(Holds::from_tails(p)).to_array(),
        ))
    }

    #[inline(always)]
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        Tails::from_array(T::rounded(
            Margin::Relative,
            #[inline(always)]
            || {
                self.quick()
                    .unwarp_tails(Holds::from_direction(at))
                    .to_array()
            },
            #[inline(always)]
            || {
                self.accurate()
                    .unwarp_tails(Holds::from_direction(at))
                    .to_array()
            },
        ))
    }

    #[inline(always)]
    fn warp_spherical(&self, p: Tails<T>, azimuth: Azimuth<T>) -> [T; 3] {
        T::rounded(
            Margin::Relative,
            #[inline(always)]
            || {
                let at = self.quick().warp_tails(Holds::from_tails(p));
                spherical(at, azimuth.quick())
            },
            #[inline(always)]
            || {
                let at = self.accurate().warp_tails(Holds::from_tails(p));
                spherical(at, azimuth.accurate())
            },
        )
    }

    /// A power of the sine has many times its error, so that no margin holds for the quick phase.
    #[inline]
    fn unwarp_spherical(&self, d: [T; 3]) -> [T; 2] {
        T::rounded(
            Margin::Unbounded,
            #[inline(always)]
            || {
                let (at, turn) = polar(d);
                [self.quick().unwarp_tails(at).lower(), turn]
            },
            || {
                let (at, turn) = polar(d);
                [self.accurate().unwarp_tails(at).lower(), turn]
            },
        )
    }

    #[inline(always)]
    fn quantile_tails(&self, p: Tails<T>) -> T {
        let [theta] = T::rounded(
            Margin::Relative,
            #[inline(always)]
            || [self.quick().quantile_tails(Holds::from_tails(p))],
            #[inline(always)]
            || [self.accurate().quantile_tails(Holds::from_tails(p))],
        );
        into_support(theta)
    }

    #[inline(always)]
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        let [weight] = T::rounded(
            Margin::Relative,
            #[inline(always)]
            || [self.quick().lambert_weight(Holds::from_components(at))],
            #[inline(always)]
            || [self.accurate().lambert_weight(Holds::from_components(at))],
        );
        weight
    }

    #[inline]
    fn moments(&self) -> Moments<T> {
        Phases::moments(self)
    }
}

/// [`Spatial::pdf_solid_angle`](super::Spatial::pdf_solid_angle) of a law of this crate.
#[inline(always)]
pub(crate) fn pdf_solid_angle<T: Real, L: Own + Phases<T>>(law: &L, theta: T) -> T {
    let [p] = T::rounded(
        Margin::Relative,
        #[inline(always)]
        || [law.quick().density_at(Holds::from_number(theta))],
        || [law.accurate().density_at(Holds::from_number(theta))],
    );
    p
}
