//! The tail of the disk's law and its inverse: Kepler's equation at eccentricity 1.
//!
//! With η the angle from the nearer end of the support and p that end's tail,
//! 2πp = 2η − sin 2η. The difference loses all digits for small η, so each direction is a
//! polynomial in the right variable instead: p/η³ in η², and η/s in s² with s = ∛(12πp).
//! Around the axis θ/d in d², d = ½ − p, gives θ its own digits.

use super::cbrt::cbrt_times;
use super::pair::Pair;
use super::poly::horner;
use super::trig::{from_end, small};
use crate::CosSin;
use crate::number::native::Native;

/// Nearer tail of the disk's law at |θ| = a ≤ π/2.
#[inline]
pub(crate) fn tail_at_angle<T: Native>(a: T) -> T {
    let table = &T::TABLE;
    let eta = from_end(a);
    let h = eta.hi * eta.hi;
    let c0 = T::CONSTANTS.two_over_three_pi;
    let shape = Pair::fast_sum(c0.hi, c0.lo + h * horner(h, table.disk_tail));
    // d ln p / d ln η falls from 3 at the end to 2 at the axis, nearly linearly in η².
    let slope = T::int(3) - h * (T::int(2) / T::int(5));
    let cube = Pair {
        hi: h * eta.hi,
        lo: slope * h * eta.lo,
    };
    cube.times(shape).value()
}

/// Nearer tail of the disk's law at a direction, from the smaller of cos θ and |sin θ|.
#[inline]
pub(crate) fn tail_at_pair<T: Native>(cos: T, sin: T) -> T {
    let table = &T::TABLE;
    if cos <= sin {
        let w = cos * cos;
        let c0 = T::CONSTANTS.two_over_three_pi;
        cos * w * (c0.hi + (c0.lo + w * horner(w, table.disk_tail_of_cos)))
    } else {
        let w = sin * sin;
        let line = Pair::product(sin, T::CONSTANTS.two_over_pi.hi);
        let rest =
            sin * T::CONSTANTS.two_over_pi.lo + sin * w * horner(w, table.disk_centre_of_sin);
        (T::HALF - line.hi) - (line.lo + rest)
    }
}

/// The angle whose nearer tail is p ≤ ½: from the end where p < ⅛ (`true`), else from the axis.
#[inline]
fn solve<T: Native>(p: T) -> (Pair<T>, bool) {
    let table = &T::TABLE;
    if p < T::QUARTER * T::HALF {
        let s = cbrt_times(T::CONSTANTS.twelve_pi, p);
        let t = s * s;
        let eta = Pair::fast_sum(s * T::HALF, s * t * horner(t, table.kepler_tail));
        (eta, true)
    } else {
        let d = T::HALF - p;
        let w = d * d;
        // θ = d + (d/2 + small): d is exact, so rounding cannot undo a step of it and θ is monotone.
        let excess = (T::CONSTANTS.half_pi.hi - T::ONE - T::HALF) + T::CONSTANTS.half_pi.lo;
        let rest = d * T::HALF + d * (excess + w * horner(w, table.kepler_centre));
        (Pair::fast_sum(d, rest), false)
    }
}

/// (cos θ, |sin θ|) at the nearer tail p.
#[inline]
pub(crate) fn pair_at_tail<T: Native>(p: T) -> CosSin<T> {
    let (x, at_end) = solve(p);
    let CosSin { cos, sin } = small(x);
    let (cos, sin) = (cos.value(), sin.value());
    if at_end {
        CosSin { cos: sin, sin: cos }
    } else {
        CosSin { cos, sin }
    }
}

/// |θ| at the nearer tail p. Rounded once from a pair, hence monotone in p.
#[inline]
pub(crate) fn angle_at_tail<T: Native>(p: T) -> T {
    let (x, at_end) = solve(p);
    if at_end {
        let end = T::CONSTANTS.half_pi;
        let theta = Pair::fast_sum(end.hi, -x.hi);
        theta.hi + (theta.lo + (end.lo - x.lo))
    } else {
        x.value()
    }
}
