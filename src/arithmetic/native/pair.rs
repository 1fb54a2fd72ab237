//! An unevaluated sum of two numbers, for the few places where one is not enough.

use super::float::Float;

/// The value `hi + lo`, `lo` small against `hi`.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Pair<T> {
    pub(crate) hi: T,
    pub(crate) lo: T,
}

impl<T: Float> Pair<T> {
    #[inline(always)]
    pub(crate) fn from_value(hi: T) -> Self {
        Pair { hi, lo: T::ZERO }
    }

    /// a/b.
    pub(crate) fn ratio(a: i16, b: i16) -> Self {
        Pair::from_value(T::int(a)).div(Pair::from_value(T::int(b)))
    }

    /// a + b without error, for |a| ≥ |b| or a = 0.
    #[inline(always)]
    pub(crate) fn fast_two_sum(a: T, b: T) -> Self {
        let hi = a + b;
        Pair {
            hi,
            lo: b - (hi - a),
        }
    }

    /// a + b without error.
    #[inline(always)]
    pub(crate) fn two_sum(a: T, b: T) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        Pair {
            hi,
            lo: (a - (hi - b_part)) + (b - b_part),
        }
    }

    /// a·b, to the square of the format's precision. Splits by masking bits, which cannot overflow.
    #[inline]
    pub(crate) fn two_prod(a: T, b: T) -> Self {
        let hi = a * b;
        let (ah, bh) = (a.leading_half(), b.leading_half());
        let (al, bl) = (a - ah, b - bh);
        Pair {
            hi,
            lo: (((ah * bh - hi) + ah * bl) + al * bh) + al * bl,
        }
    }

    #[inline(always)]
    pub(crate) fn value(self) -> T {
        self.hi + self.lo
    }

    #[inline(always)]
    pub(crate) fn neg(self) -> Self {
        Pair {
            hi: -self.hi,
            lo: -self.lo,
        }
    }

    #[inline(always)]
    pub(crate) fn half(self) -> Self {
        Pair {
            hi: self.hi * T::HALF,
            lo: self.lo * T::HALF,
        }
    }

    /// First-order product: carries the factors' low parts but not the rounding of `hi·hi`.
    #[inline(always)]
    pub(crate) fn times(self, b: Self) -> Self {
        Pair {
            hi: self.hi * b.hi,
            lo: self.hi * b.lo + self.lo * b.hi,
        }
    }

    /// As [`mul`](Self::mul), not normalised: the trailing word may be a few last places.
    #[inline(always)]
    pub(crate) fn mul_raw(self, b: Self) -> Self {
        let p = Self::two_prod(self.hi, b.hi);
        Pair {
            hi: p.hi,
            lo: p.lo + (self.hi * b.lo + self.lo * b.hi),
        }
    }

    #[inline]
    pub(crate) fn mul(self, b: Self) -> Self {
        let p = Self::two_prod(self.hi, b.hi);
        Self::fast_two_sum(p.hi, p.lo + (self.hi * b.lo + self.lo * b.hi))
    }

    #[inline]
    pub(crate) fn add(self, b: Self) -> Self {
        let s = Self::two_sum(self.hi, b.hi);
        Self::fast_two_sum(s.hi, s.lo + (self.lo + b.lo))
    }

    #[inline]
    pub(crate) fn div(self, b: Self) -> Self {
        let q = self.hi / b.hi;
        let p = Self::two_prod(q, b.hi);
        let rest = ((self.hi - p.hi) - p.lo) + (self.lo - q * b.lo);
        Self::fast_two_sum(q, rest / b.hi)
    }
}
