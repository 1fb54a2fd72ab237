//! The laws' formulas in a working arithmetic, and how they serve every number type.
//!
//! A law's file writes each formula once, on [`Kernel`]. Here the formulas run in the arithmetic
//! of a number type's tier, and their results are rounded to it.

use super::{Law, Spatial};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::native::format::Native;
use crate::law::support::into_support;
use crate::number::Real;
use crate::number::tier::Margin;
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
    type Accurate: Formulas<T::Accurate>;
    fn quick(&self) -> Self::Quick;
    fn accurate(&self) -> Self::Accurate;
    fn moments(&self) -> Moments<T>;
}

impl<T: Real, L> In<T> for L
where
    L: Fixed + Formulas<T::Quick> + Formulas<T::Accurate>,
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
        L::moments::<T::Base>().map(T::from_base)
    }
}

impl<T: Real, L: Own + In<T>> Law<T> for L {
    #[inline]
    fn pdf(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            || [self.quick().pdf(Holds::from_number(theta))],
            || [self.accurate().pdf(Holds::from_number(theta))],
        );
        p
    }

    #[inline]
    fn ln_pdf(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::OfOne,
            || [self.quick().ln_pdf(Holds::from_number(theta))],
            || [self.accurate().ln_pdf(Holds::from_number(theta))],
        );
        p
    }

    #[inline]
    fn tails(&self, theta: T) -> Tails<T> {
        Tails::from_array(T::rounded(
            Margin::Relative,
            || self.quick().tails(Holds::from_number(theta)).to_array(),
            || self.accurate().tails(Holds::from_number(theta)).to_array(),
        ))
    }

    #[inline]
    fn density(&self, at: CosSin<T>) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            || [self.quick().density(Holds::from_components(at))],
            || [self.accurate().density(Holds::from_components(at))],
        );
        p
    }

    #[inline]
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        CosSin::from_array(T::rounded(
            Margin::Relative,
            || self.quick().warp_tails(Holds::from_tails(p)).to_array(),
            || self.accurate().warp_tails(Holds::from_tails(p)).to_array(),
        ))
    }

    #[inline]
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        Tails::from_array(T::rounded(
            Margin::Relative,
            || {
                self.quick()
                    .unwarp_tails(Holds::from_direction(at))
                    .to_array()
            },
            || {
                self.accurate()
                    .unwarp_tails(Holds::from_direction(at))
                    .to_array()
            },
        ))
    }

    #[inline]
    fn quantile_tails(&self, p: Tails<T>) -> T {
        let [theta] = T::rounded(
            Margin::Relative,
            || [self.quick().quantile_tails(Holds::from_tails(p))],
            || [self.accurate().quantile_tails(Holds::from_tails(p))],
        );
        into_support(theta)
    }

    #[inline]
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        let [weight] = T::rounded(
            Margin::Relative,
            || [self.quick().lambert_weight(Holds::from_components(at))],
            || [self.accurate().lambert_weight(Holds::from_components(at))],
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
    L::Accurate: SolidAngle<T::Accurate>,
{
    #[inline]
    fn pdf_solid_angle(&self, theta: T) -> T {
        let [p] = T::rounded(
            Margin::Relative,
            || [self.quick().pdf_solid_angle(Holds::from_number(theta))],
            || [self.accurate().pdf_solid_angle(Holds::from_number(theta))],
        );
        p
    }
}
