//! The laws' formulas in a working arithmetic, and how they serve every number type.
//!
//! A law's file writes each formula once, on [`Kernel`]. Here the formulas run in the arithmetic
//! of a number type's tier, and their results are rounded to it.

use super::Law;
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::native::format::Native;
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
    #[inline]
    fn density_at(&self, theta: W) -> W {
        self.pdf(theta)
    }

    #[inline]
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
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law",
    label = "not a law of directions",
    note = "the laws are Disk, CircleShell, CircleArc, Ball, SphereShell, Lambert and CosPower; \
            one of your own implements `coslobe::Law`"
)]
pub trait Own {}

/// A law without a parameter, which is the same in every arithmetic.
pub trait Parameterless: Own + Copy {
    /// Exact moments.
    fn moments<B: Native>() -> Moments<B>;
}

/// A law in the two phases of a number type.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law in the number type `{T}`",
    label = "no law in `{T}`",
    note = "a law with a parameter, such as CosPower, works in the number type of its parameter"
)]
pub trait Phases<T: Real> {
    type Quick: Formulas<T::Quick>;
    type Accurate: Formulas<T::Accurate>;
    fn quick(&self) -> Self::Quick;
    fn accurate(&self) -> Self::Accurate;
    fn moments(&self) -> Moments<T>;
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
        L::moments::<T::Base>().map(T::from_base)
    }
}

impl<T: Real, L: Own + Phases<T>> Law<T> for L {
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
        Phases::moments(self)
    }
}

/// [`Spatial::pdf_solid_angle`](super::Spatial::pdf_solid_angle) of a law of this crate.
#[inline]
pub(crate) fn pdf_solid_angle<T: Real, L: Own + Phases<T>>(law: &L, theta: T) -> T {
    let [p] = T::rounded(
        Margin::Relative,
        || [law.quick().density_at(Holds::from_number(theta))],
        || [law.accurate().density_at(Holds::from_number(theta))],
    );
    p
}
