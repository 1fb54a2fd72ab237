//! (cos θ, sin θ) with cosⁿθ a given tail: the n-th root of a probability, and what it leaves of 1.
//!
//! Method: y = (2/n)·log₂ of the tail; cos²θ = 2ʸ, of which cos θ is the root, which halves its
//! error, and sin²θ what it lacks of 1, from 2ʳ − 1 at y's distance r to the nearest integer. The
//! logarithm is that of the nearer tail, e + log₂(1 + f) with f exact. 2/n is held as a short
//! head, whose product with e is exact, and a rest; what is small is added last, after the sum
//! that cancels.
//!
//! No branch, no pair arithmetic in the hot path.

use super::format::Native;
use super::pair::Pair;
use super::poly::by_twos;
use crate::{CosSin, Tails};

/// What n ≥ 1 needs for it, worked out once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TailRoot<T> {
    /// 2/n.
    head: T,
    rest: T,
    /// 2/n · log₂ e.
    slope: T,
    /// `up` = −2/n · 4ⁱ, `down` = 2⁻ⁱ: sin²θ itself may underflow.
    up: T,
    down: T,
}

impl<T: Native> TailRoot<T> {
    pub(crate) fn new(n: Pair<T>) -> Self {
        let two = T::ONE + T::ONE;
        let share = Pair::from_value(two).div(n);
        let head = share.hi.exponent_factor();
        let (m, e) = n.hi.split(T::ONE);
        TailRoot {
            head,
            rest: (share.hi - head) + share.lo,
            slope: share.div(T::CONSTANTS.ln_2).value(),
            up: -two / m * T::exp2(60i32.wrapping_sub(e & 1)),
            down: T::exp2((-30i32).wrapping_sub(e >> 1)),
        }
    }

    #[inline(always)]
    pub(crate) fn at(self, p: Tails<T>) -> CosSin<T> {
        let (lower, upper) = (p.lower(), p.upper());
        // Up, so that no number is subnormal.
        let (m, e) = (upper * T::ROOT_UP).split_normal(T::ROOT_HALF);
        let e = T::from_i32(e.wrapping_sub(T::ROOT_EXPONENT));
        // What rounding took from an upper tail beyond ½: for it, e is 0 or −1.
        let lost = (T::ONE - upper) - lower;
        let ln = ln_1p((m - T::ONE) + lost * (T::ONE - e));
        let lead = e * self.head;
        let near = ln * self.slope;
        let rest = e * self.rest;
        let y = lead + near;
        let (whole, n) = y.nearest();
        let lead = (lead - whole) + near;
        let part = exp2_m1(lead, rest);

        let square = (T::ONE + part) * T::exp2(n & 1);
        let lift = T::exp2((n >> 1).wrapping_add(T::LIFT_EXPONENT));
        let cos = square.sqrt() * (lift * T::DROP);

        let power = T::exp2(n.max(T::LEAST_EXPONENT));
        let full = (T::ONE - power) - power * part;
        // −2 ln/n, to the first order: sin²θ of a large n or a small tail; no −0.
        let first = ((e * T::CONSTANTS.ln_2.hi + ln) * self.up).abs();
        let slight = y > -T::SLIGHT;
        let sin = T::select(slight, first, full).sqrt() * T::select(slight, self.down, T::ONE);

        let nothing = upper == T::ZERO;
        CosSin {
            cos: T::select(nothing, T::ZERO, cos),
            sin: T::select(nothing, T::ONE, sin),
        }
    }
}

/// 2ʳ − 1, r = `lead` + `rest` and |r| ≤ ½ or little more: its first term's leading digits exact.
#[inline(always)]
fn exp2_m1<T: Native>(lead: T, rest: T) -> T {
    let Pair { hi: ln_2, lo } = T::TABLE.ln_2;
    let (r, head) = (lead + rest, lead.leading_half());
    let bend = r * r * by_twos(r, T::TABLE.exp2_bend);
    head * ln_2 + (((lead - head) + rest) * ln_2 + (r * lo + bend))
}

/// ln(1 + f) for √½ ≤ 1 + f ≤ √2, as f − f²/2 + s(f²/2 + 2s²/3 + …), s = f/(2 + f).
#[inline(always)]
fn ln_1p<T: Native>(f: T) -> T {
    let s = f / (T::ONE + T::ONE + f);
    let w = s * s;
    let half_square = f * f * T::HALF;
    f - (half_square - s * (half_square + w * by_twos(w, T::TABLE.atanh)))
}
