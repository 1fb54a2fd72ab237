//! Powers of two.

use super::format::Native;
use super::pair::Pair;
use super::poly::by_fours;

/// y as a whole number and a rest of at most a half, with what rounding took from it.
#[inline(always)]
pub(crate) fn whole_and_rest<T: Native>(y: Pair<T>) -> (i32, Pair<T>) {
    let (whole, n) = y.value().nearest();
    let lead = y.hi - whole;
    let hi = lead + y.lo;
    let lo = (lead - hi) + y.lo;
    (n, Pair { hi, lo })
}

/// 2ʳ − 1 for |r| ≤ ½: its first term's leading digits exact, the rest in a smaller place.
#[inline(always)]
pub(crate) fn exp2_m1<T: Native>(r: Pair<T>) -> Pair<T> {
    let Pair { hi: ln_2, lo: rest } = T::TABLE.ln_2;
    let head = r.hi.leading_half();
    let bend = r.hi * r.hi * by_fours(r.hi, T::TABLE.exp2_bend);
    Pair {
        hi: head * ln_2,
        lo: ((r.hi - head) + r.lo) * ln_2 + (r.hi * rest + bend),
    }
}

/// A positive number as a significand from 1 to 2, with what rounding took from it, times 2ⁿ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale<T> {
    pub(crate) significand: Pair<T>,
    pub(crate) exponent: i32,
}

impl<T: Native> Scale<T> {
    pub(crate) fn new(x: Pair<T>) -> Self {
        let (m, e) = x.hi.split(T::ONE);
        let lo = x.lo.scale(e.wrapping_neg());
        Scale {
            significand: Pair { hi: m, lo },
            exponent: e,
        }
    }

    /// 2/x.
    pub(crate) fn two_over(x: Pair<T>) -> Self {
        let Scale {
            significand,
            exponent,
        } = Scale::new(x);
        Scale {
            significand: Pair::from_value(T::ONE + T::ONE).div(significand),
            exponent: exponent.wrapping_neg(),
        }
    }

    /// self·(1 + p)·2ⁿ·`factor`, rounded to a subnormal number once.
    #[inline(always)]
    pub(crate) fn times(self, p: T, n: i32, factor: T) -> T {
        let m = self.significand.hi + (self.significand.lo + self.significand.hi * p);
        // A subnormal factor must not meet a power below 1 first.
        let small = factor < T::LIFT_BELOW;
        let factor = T::select(small, factor * T::LIFT, factor);
        let lift = if small { T::LIFT_EXPONENT } else { 0 };
        let n = n.wrapping_add(self.exponent).wrapping_sub(lift);
        let n = n.max(-T::TWICE_EXPONENT).min(T::TWICE_EXPONENT);
        let half = n >> 1;
        m * T::exp2(half) * factor * T::exp2(n.wrapping_sub(half))
    }
}
