//! The laws' formulas in a working arithmetic, and how they serve every number type.
//!
//! A law's file writes each formula once, on [`Kernel`]. Here the formulas run in the arithmetic
//! of a number type's tier, and their results are rounded to it.

use super::{Law, Spatial};
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::tier::{Holds, Margin};
use crate::law::select::into_support;
use crate::number::Real;
use crate::{CosSin, Moments, Tails};

/// What [`Law`] promises, in working arithmetic.
pub trait Formulas<W: Kernel> {
    fn pdf(&self, theta: W) -> W;
    fn ln_pdf(&self, theta: W) -> W;
    fn tails(&self, theta: W) -> Tails<W>;
    fn density(&self, at: CosSin<W>) -> W;
    fn warp_tails(&self, p: Tails<W>) -> CosSin<W>;
    fn unwarp_tails(&self, at: CosSin<W>) -> Tails<W>;
    fn lambert_weight(&self, at: CosSin<W>) -> W;

    #[inline]
    fn quantile_tails(&self, p: Tails<W>) -> W {
        W::angle(self.warp_tails(p))
    }
}

/// What [`Spatial`] adds to [`Law`].
pub trait SolidAngle<W: Kernel>: Formulas<W> {
    fn pdf_solid_angle(&self, theta: W) -> W;
}

/// A law of this crate. Without a parameter, so that a law of another crate can be seen to be none.
pub trait Own {}

/// A law without parameters, and its exact moments.
pub trait Fixed: Own + Copy {
    fn moments<B: Native>() -> Moments<B>;
}

/// A law as the arithmetics of a number type see it.
pub trait In<T: Real> {
    type Quick: Formulas<T::Quick>;
    type Work: Formulas<T::Work>;
    fn quick(&self) -> Self::Quick;
    fn work(&self) -> Self::Work;
    fn moments(&self) -> Moments<T>;
}

impl<T: Real, L> In<T> for L
where
    L: Fixed + Formulas<T::Quick> + Formulas<T::Work>,
{
    type Quick = L;
    type Work = L;

    #[inline(always)]
    fn quick(&self) -> L {
        *self
    }

    #[inline(always)]
    fn work(&self) -> L {
        *self
    }

    #[inline]
    fn moments(&self) -> Moments<T> {
        L::moments::<T::Base>().map(T::of_base)
    }
}

impl<T: Real, L: Own + In<T>> Law<T> for L {
    #[inline]
    fn pdf(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            || [self.quick().pdf(Holds::of(theta))],
            || [self.work().pdf(Holds::of(theta))],
        );
        p
    }

    #[inline]
    fn ln_pdf(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::OfOne,
            || [self.quick().ln_pdf(Holds::of(theta))],
            || [self.work().ln_pdf(Holds::of(theta))],
        );
        p
    }

    #[inline]
    fn tails(&self, theta: T) -> Tails<T> {
        Tails::of_array(T::rounded(
            Margin::Relative,
            || self.quick().tails(Holds::of(theta)).to_array(),
            || self.work().tails(Holds::of(theta)).to_array(),
        ))
    }

    #[inline]
    fn density(&self, at: CosSin<T>) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            || [self.quick().density(Holds::of_pair(at))],
            || [self.work().density(Holds::of_pair(at))],
        );
        p
    }

    #[inline]
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        CosSin::of_array(T::rounded(
            Margin::Relative,
            || self.quick().warp_tails(Holds::of_tails(p)).to_array(),
            || self.work().warp_tails(Holds::of_tails(p)).to_array(),
        ))
    }

    #[inline]
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        Tails::of_array(T::rounded(
            Margin::Relative,
            || {
                self.quick()
                    .unwarp_tails(Holds::of_direction(at))
                    .to_array()
            },
            || self.work().unwarp_tails(Holds::of_direction(at)).to_array(),
        ))
    }

    #[inline]
    fn quantile_tails(&self, p: Tails<T>) -> T {
        let [theta] = T::rounded(
            Margin::Relative,
            || [self.quick().quantile_tails(Holds::of_tails(p))],
            || [self.work().quantile_tails(Holds::of_tails(p))],
        );
        into_support(theta)
    }

    #[inline]
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        let [weight] = T::rounded(
            Margin::Relative,
            || [self.quick().lambert_weight(Holds::of_pair(at))],
            || [self.work().lambert_weight(Holds::of_pair(at))],
        );
        weight
    }

    #[inline]
    fn moments(&self) -> Moments<T> {
        In::moments(self)
    }
}

impl<T: Real, L: Own + In<T>> Spatial<T> for L
where
    L::Quick: SolidAngle<T::Quick>,
    L::Work: SolidAngle<T::Work>,
{
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            || [self.quick().pdf_solid_angle(Holds::of(theta))],
            || [self.work().pdf_solid_angle(Holds::of(theta))],
        );
        p
    }
}
