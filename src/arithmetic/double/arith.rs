//! The steps that the kernels share, each as cheap as its place allows.

use super::Double;
use crate::arithmetic::native::pair::Pair;

/// A factor for `mul_raw` and the like: results that are not normalised, lo a few ulps of hi.
#[inline(always)]
pub(crate) fn mul_raw(a: Double, b: Double) -> Double {
    let p = Pair::two_prod(a.hi, b.hi);
    Pair {
        hi: p.hi,
        lo: p.lo + (a.hi * b.lo + a.lo * b.hi),
    }
}

/// a², not normalised.
#[inline(always)]
pub(crate) fn square_raw(a: Double) -> Double {
    let p = Pair::two_prod(a.hi, a.hi);
    Pair {
        hi: p.hi,
        lo: p.lo + 2.0 * a.hi * a.lo,
    }
}

/// a + b, not normalised, for |a| ≥ |b|.
#[inline(always)]
pub(crate) fn add_raw(a: Double, b: Double) -> Double {
    let s = Pair::fast_two_sum(a.hi, b.hi);
    Pair {
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
    Pair::fast_two_sum(a.hi, a.lo)
}

/// a − b as one f64, for a and b that agree to many digits.
#[inline(always)]
pub(crate) fn gap(a: Double, b: Double) -> f64 {
    (a.hi - b.hi) + (a.lo - b.lo)
}

/// a·2ᵏ given 2ᵏ.
#[inline(always)]
pub(crate) fn scaled(a: Double, power: f64) -> Double {
    Pair {
        hi: a.hi * power,
        lo: a.lo * power,
    }
}
