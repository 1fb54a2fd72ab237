//! A probability held as both its tails.

use crate::scalar::{BY_SELECTS, Scalar};

/// A probability as the pair (cdf, sf), each to full relative accuracy.
///
/// Neither is ever formed as 1 minus a rounded other one, so both ends of a law are reached
/// with all digits. The nearer tail (the smaller) is exact, the other is 1 minus it, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tails<T> {
    lower: T,
    upper: T,
}

impl<T: Scalar> Tails<T> {
    /// The tails at cdf = `u`; NaN for `u` outside \[0, 1\].
    #[inline]
    pub fn from_lower(u: T) -> Self {
        Self::at_lower(u.probability())
    }

    /// The tails at cdf = `lower`, a [probability](Scalar::probability) or NaN.
    #[inline(always)]
    pub(crate) fn at_lower(lower: T) -> Self {
        Tails {
            lower,
            upper: T::ONE - lower,
        }
    }

    /// The tails at sf = `q`; NaN for `q` outside \[0, 1\].
    #[inline]
    pub fn from_upper(q: T) -> Self {
        let upper = q.probability();
        Tails {
            lower: T::ONE - upper,
            upper,
        }
    }

    /// Nearer tail `p` ≤ ½, on the upper side or the lower.
    #[inline(always)]
    pub(crate) fn from_nearer(p: T, is_upper: bool) -> Self {
        let (lower, upper) = T::swap_if_odd(u32::from(is_upper), p, T::ONE - p);
        Tails { lower, upper }
    }

    /// [`from_nearer`](Tails::from_nearer) for p > 0 and a random side, by sums: numbers stay in
    /// their registers, which masks take them out of.
    #[inline(always)]
    pub(crate) fn from_side(p: T, is_upper: bool) -> Self {
        if !BY_SELECTS {
            return Self::from_nearer(p, is_upper);
        }
        let side = u32::from(is_upper);
        let (from, to) = T::swap_if_odd(side, T::ZERO, T::ONE);
        let p = p.negate_if_odd(side);
        Tails {
            lower: from + p,
            upper: to - p,
        }
    }

    /// From both tails as computed apart from each other: keeps the nearer one.
    #[inline(always)]
    pub(crate) fn from_both(lower: T, upper: T) -> Self {
        if upper <= lower {
            Self::from_nearer(upper, true)
        } else {
            Self::from_nearer(lower, false)
        }
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [T; 2] {
        [self.lower, self.upper]
    }

    #[inline(always)]
    pub(crate) fn from_array([lower, upper]: [T; 2]) -> Self {
        Tails { lower, upper }
    }

    /// Probability below: the cdf.
    #[inline(always)]
    pub fn lower(self) -> T {
        self.lower
    }

    /// Probability above: the survival function.
    #[inline(always)]
    pub fn upper(self) -> T {
        self.upper
    }

    /// The smaller tail, and 1 if it is the lower one, else 0 (as for equal tails).
    #[inline(always)]
    pub(crate) fn nearer(self) -> (T, u32) {
        // In this form a minimum is one instruction on most processors.
        let p = if self.upper < self.lower {
            self.upper
        } else {
            self.lower
        };
        (p, (self.lower - self.upper).sign_bit())
    }
}
