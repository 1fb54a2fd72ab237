//! The type, and the steps that its kernels share, each as cheap as its place allows.

use crate::arithmetic::native::pair::Pair;

/// A number of about 104 bits: hi + lo, hi the nearest `f64`.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Double {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl Double {
    #[inline(always)]
    pub(crate) const fn from_pair(x: Pair<f64>) -> Self {
        Double { hi: x.hi, lo: x.lo }
    }

    #[inline(always)]
    const fn pair(self) -> Pair<f64> {
        Pair {
            hi: self.hi,
            lo: self.lo,
        }
    }

    #[inline(always)]
    pub(crate) const fn from_f64(hi: f64) -> Self {
        Double { hi, lo: 0.0 }
    }

    /// a + b without error, for |a| ≥ |b| or a = 0.
    #[inline(always)]
    pub(crate) fn fast_two_sum(a: f64, b: f64) -> Self {
        Self::from_pair(Pair::fast_two_sum(a, b))
    }

    /// a + b without error.
    #[inline(always)]
    pub(crate) fn two_sum(a: f64, b: f64) -> Self {
        Self::from_pair(Pair::two_sum(a, b))
    }

    /// a·b, off by at most one unit of 2⁻¹⁰⁴.
    #[inline]
    pub(crate) fn two_prod(a: f64, b: f64) -> Self {
        Self::from_pair(Pair::two_prod(a, b))
    }
}

/// a + b for results other than 0 and ∞, for which the operators stand.
#[inline]
pub(crate) fn sum(a: Double, b: Double) -> Double {
    Double::from_pair(a.pair().add(b.pair()))
}

/// a·b for the same results.
#[inline]
pub(crate) fn product(a: Double, b: Double) -> Double {
    Double::from_pair(a.pair().mul(b.pair()))
}

/// a/b for the same results.
#[inline]
pub(crate) fn quotient(a: Double, b: Double) -> Double {
    Double::from_pair(a.pair().div(b.pair()))
}

/// A factor for `mul_raw` and the like: results that are not normalised, lo a few ulps of hi.
#[inline(always)]
pub(crate) fn mul_raw(a: Double, b: Double) -> Double {
    let p = Double::two_prod(a.hi, b.hi);
    Double {
        hi: p.hi,
        lo: p.lo + (a.hi * b.lo + a.lo * b.hi),
    }
}

/// a², not normalised.
#[inline(always)]
pub(crate) fn square_raw(a: Double) -> Double {
    let p = Double::two_prod(a.hi, a.hi);
    Double {
        hi: p.hi,
        lo: p.lo + 2.0 * a.hi * a.lo,
    }
}

/// a + b, not normalised, for |a| ≥ |b|.
#[inline(always)]
pub(crate) fn add_raw(a: Double, b: Double) -> Double {
    let s = Double::fast_two_sum(a.hi, b.hi);
    Double {
        hi: s.hi,
        lo: s.lo + (a.lo + b.lo),
    }
}

/// a + b for |a| ≥ |b|.
#[inline(always)]
pub(crate) fn add_smaller(a: Double, b: Double) -> Double {
    normalise(add_raw(a, b))
}

#[inline(always)]
pub(crate) fn normalise(a: Double) -> Double {
    Double::fast_two_sum(a.hi, a.lo)
}

/// a − b as one f64, for a and b that agree to many digits.
#[inline(always)]
pub(crate) fn gap(a: Double, b: Double) -> f64 {
    (a.hi - b.hi) + (a.lo - b.lo)
}

/// a·2ᵏ given 2ᵏ.
#[inline(always)]
pub(crate) fn scaled(a: Double, power: f64) -> Double {
    Double {
        hi: a.hi * power,
        lo: a.lo * power,
    }
}
