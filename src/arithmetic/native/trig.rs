//! (cos θ, sin θ) of an angle within the support.

use super::pair::Pair;
use super::poly::horner;
use crate::CosSin;
use crate::arithmetic::native::format::Native;

/// Cosine and sine in each other's place if `swap`.
fn swap_if<T>(at: CosSin<T>, swap: bool) -> CosSin<T> {
    if swap {
        CosSin {
            cos: at.sin,
            sin: at.cos,
        }
    } else {
        at
    }
}

/// ln cos θ. Near the axis it is read from the sine: ln of a cosine near 1 has few digits.
#[inline(always)]
pub(crate) fn ln_cos<T: Native>(at: CosSin<Pair<T>>) -> T {
    if at.cos.hi < at.sin.hi {
        at.cos.value().ln()
    } else {
        (-at.sin.times(at.sin).value()).ln_1p() * T::HALF
    }
}

/// π/2 − a for 0 ≤ a ≤ π/2, with π/2 to twice the format's digits: cos θ must not
/// lose its own digits where θ runs into ±π/2.
#[inline(always)]
pub(crate) fn from_end<T: Native>(a: T) -> Pair<T> {
    let d = Pair::fast_two_sum(T::CONSTANTS.half_pi.hi, -a);
    Pair::fast_two_sum(d.hi, d.lo + T::CONSTANTS.half_pi.lo)
}

/// The angle folded to [0, π/4], and whether cosine and sine change places for it.
#[inline(always)]
fn fold<T: Native>(theta: T) -> (Pair<T>, bool) {
    let a = theta.abs();
    let far = a > T::CONSTANTS.half_pi.hi * T::HALF;
    (
        if far {
            from_end(a)
        } else {
            Pair::from_value(a)
        },
        far,
    )
}

/// (cos x, sin x) for 0 ≤ x ≤ 0.9, hi + lo a fraction of an ulp off: half of this cosine is the
/// pdf of `CircleShell`, whose row in the accuracy table is its error and one rounding.
#[inline(always)]
pub(crate) fn small<T: Native>(x: Pair<T>) -> CosSin<Pair<T>> {
    // Too small to count is 0: subnormal products stall some processors a hundredfold.
    let v = x.hi * x.hi;
    let v = T::select(
        v < T::NEGLIGIBLE * T::NEGLIGIBLE * T::NEGLIGIBLE,
        T::ZERO,
        v,
    );
    let half_v = v * T::HALF;
    let w = T::ONE - half_v;
    let rest = x.lo * w + x.hi * v * horner(v, T::TABLE.sin);
    let cos_rest = ((T::ONE - w) - half_v) + (v * v * horner(v, T::TABLE.cos) - x.hi * x.lo);
    CosSin {
        cos: Pair::fast_two_sum(w, cos_rest),
        sin: Pair::fast_two_sum(x.hi, rest),
    }
}

/// (cos θ, |sin θ|) for |θ| ≤ π/2.
#[inline(always)]
pub(crate) fn at_angle<T: Native>(theta: T) -> CosSin<Pair<T>> {
    let (x, far) = fold(theta);
    swap_if(small(x), far)
}

/// sin x for 0 ≤ x ≤ π/4 to about 2⁻³² (`f32`) or 2⁻⁶⁴ (`f64`) of itself; not normalised.
#[inline(always)]
fn sine<T: Native>(x: Pair<T>) -> Pair<T> {
    let v = x.mul_raw(x);
    let tail = v.hi * horner(v.hi, T::TABLE.sine_tail);
    let mut sum = Pair {
        hi: tail,
        lo: T::ZERO,
    };
    let mut rest = sum;
    for &c in T::TABLE.sine_head.iter().rev() {
        let first = Pair::fast_two_sum(c.hi, rest.hi);
        sum = Pair {
            hi: first.hi,
            lo: first.lo + (c.lo + rest.lo),
        };
        rest = sum.mul_raw(v);
    }
    let bend = x.mul_raw(v).mul_raw(sum);
    let first = Pair::fast_two_sum(x.hi, bend.hi);
    Pair {
        hi: first.hi,
        lo: first.lo + (x.lo + bend.lo),
    }
}

/// The smaller of cos θ and |sin θ| for |θ| ≤ π/2 with the digits that a power needs, whether it
/// is cos θ, and the other.
#[inline(always)]
pub(crate) fn sine_at_angle<T: Native>(theta: T) -> (Pair<T>, bool, T) {
    let a = theta.abs();
    let far = a > T::CONSTANTS.half_pi.hi * T::HALF;
    // Three words of π/2: beside it the first two cancel, and a power multiplies what is left out.
    let d = Pair::fast_two_sum(T::CONSTANTS.half_pi.hi, -a);
    let s = Pair::fast_two_sum(d.hi, T::CONSTANTS.half_pi.lo);
    let end = Pair::fast_two_sum(s.hi, s.lo + (d.lo + T::TABLE.half_pi_rest));
    let x = Pair {
        hi: T::select(far, end.hi, a),
        lo: T::select(far, end.lo, T::ZERO),
    };
    let v = x.hi * x.hi;
    let other = T::ONE - (v * T::HALF - v * v * horner(v, T::TABLE.cos));
    (sine(x), far, other)
}
