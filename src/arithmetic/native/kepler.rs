//! The tail of the disk's law and its inverse: Kepler's equation at eccentricity 1.
//!
//! With η the angle from the nearer end of the support and p that end's tail,
//! 2πp = 2η − sin 2η. The difference loses all digits for small η, so each direction is a
//! polynomial in the right variable instead: p/η³ in η², and η/s in s² with s = ∛(12πp).
//! Around the axis θ/d in d², d = ½ − p, gives θ its own digits.

use super::cbrt::cbrt_times;
use super::pair::Pair;
use super::poly::{by_fours, horner};
use super::trig::{from_end, small};
use crate::CosSin;
use crate::arithmetic::native::format::Native;

/// Nearer tail of the disk's law at |θ| = a ≤ π/2.
#[inline(always)]
pub(crate) fn tail_at_angle<T: Native>(a: T) -> T {
    let table = &T::TABLE;
    let eta = from_end(a);
    let h = eta.hi * eta.hi;
    let c0 = T::CONSTANTS.two_over_three_pi;
    let shape = Pair::fast_two_sum(c0.hi, c0.lo + h * horner(h, table.disk_tail));
    // d ln p / d ln η falls from 3 at the end to 2 at the axis, nearly linearly in η².
    let slope = T::int(3) - h * (T::int(2) / T::int(5));
    let cube = Pair {
        hi: h * eta.hi,
        lo: slope * h * eta.lo,
    };
    cube.times(shape).value()
}

/// Nearer tail of the disk's law at a direction, from the smaller of cos θ and |sin θ|.
#[inline(always)]
pub(crate) fn tail_at_direction<T: Native>(cos: T, sin: T) -> T {
    let table = &T::TABLE;
    if cos <= sin {
        let w = cos * cos;
        let c0 = T::CONSTANTS.two_over_three_pi;
        cos * w * (c0.hi + (c0.lo + w * horner(w, table.disk_tail_of_cos)))
    } else {
        let w = sin * sin;
        let line = Pair::two_prod(sin, T::CONSTANTS.two_over_pi.hi);
        let rest =
            sin * T::CONSTANTS.two_over_pi.lo + sin * w * horner(w, table.disk_centre_of_sin);
        (T::HALF - line.hi) - (line.lo + rest)
    }
}

/// The tail below which an angle is measured from the end, above which from the axis.
#[inline(always)]
fn split<T: Native>() -> T {
    T::QUARTER * T::HALF
}

/// The angle from the end whose tail is p < ⅛.
#[inline(always)]
fn from_end_at<T: Native>(p: T) -> Pair<T> {
    let s = cbrt_times(T::CONSTANTS.twelve_pi, p);
    let t = s * s;
    let bend = by_fours(t, T::TABLE.kepler_tail);
    Pair::fast_two_sum(s * T::HALF, s * t * bend)
}

/// The angle from the axis whose nearer tail is p ≥ ⅛, as d = ½ − p and the rest.
///
/// d is exact from p = ¼ on and rounded monotonically below it, so a step of p is never undone.
#[inline(always)]
fn from_axis_at<T: Native>(p: T) -> (T, T) {
    let d = T::HALF - p;
    let w = d * d;
    let excess = (T::CONSTANTS.half_pi.hi - T::ONE - T::HALF) + T::CONSTANTS.half_pi.lo;
    let bend = by_fours(w, T::TABLE.kepler_centre);
    (d, d * T::HALF + (d * excess + d * w * bend))
}

/// (cos θ, |sin θ|) at the nearer tail p. Proved: errors ≤ 2.5 ulp (f64), ≤ 2.4 (f32).
#[inline(always)]
pub(crate) fn direction_at_tail<T: Native>(p: T) -> CosSin<T> {
    let x = if p < split() {
        from_end_at(p)
    } else {
        let (d, rest) = from_axis_at(p);
        Pair::fast_two_sum(d, rest)
    };
    let CosSin { cos, sin } = small(x);
    let (cos, sin) = T::swap_if_odd((p - split()).sign_bit(), cos.value(), sin.value());
    CosSin { cos, sin }
}

/// |θ| at the nearer tail p. Rounded once from a pair, hence monotone in p.
///
/// Proved: error ≤ 2.5 ulp (f64), ≤ 2.4 (f32).
#[inline(always)]
pub(crate) fn angle_at_tail<T: Native>(p: T) -> T {
    if p < split() {
        let (eta, end) = (from_end_at(p), T::CONSTANTS.half_pi);
        let theta = Pair::fast_two_sum(end.hi, -eta.hi);
        theta.hi + (theta.lo + (end.lo - eta.lo))
    } else {
        let (d, rest) = from_axis_at(p);
        d + rest
    }
}
