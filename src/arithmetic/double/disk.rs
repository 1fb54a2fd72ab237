//! The tail of the disk's law and its inverse: Kepler's equation at eccentricity 1.
//!
//! With η the angle from the nearer end, θ from the axis and p that end's tail, πp = η − sin η cos
//! η and π(½ − p) = θ + sin θ cos θ. The difference is summed from parts of one sign.

use super::angle::{from_end, sin_cos_gap, swapped};
use super::arith::Double;
use super::arith::{add_raw, add_smaller, gap, mul_raw, normalise, quotient, square_raw, sum};
use super::coefficients::{PI, QUARTER_PI, RECIP_PI};
use crate::CosSin;
use crate::arithmetic::native::cbrt::cbrt_times;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::poly::horner;

/// An angle up to 0.9 with its cosine and sine, and the area that the law measures.
struct Arc {
    at: CosSin<Double>,
    area: Double,
}

impl Arc {
    /// x − sin x cos x, as (x − sin x) cos x + x (1 − cos x).
    #[inline(always)]
    fn from_end(x: Double) -> Arc {
        let (at, rest) = sin_cos_gap(x);
        let versine = quotient(
            square_raw(at.sin),
            add_smaller(Double::from_f64(1.0), at.cos),
        );
        let area = add_raw(mul_raw(x, versine), -mul_raw(rest, at.cos));
        Arc { at, area }
    }

    /// x + sin x cos x.
    #[inline(always)]
    fn from_axis(x: Double) -> Arc {
        let (at, _) = sin_cos_gap(x);
        let area = add_raw(x, mul_raw(at.sin, at.cos));
        Arc { at, area }
    }

    /// The area at x + d, by its slope 2 sin² or 2 cos² of x: d² is below 2⁻¹⁰⁰ of x².
    #[inline(always)]
    fn area_beyond(&self, root_of_half_slope: f64, d: f64) -> Double {
        let more = 2.0 * root_of_half_slope * root_of_half_slope * d;
        Double {
            hi: self.area.hi,
            lo: self.area.lo + more,
        }
    }

    /// How far the angle is from the one whose area is `area`, which differs by rounding alone.
    #[inline(always)]
    fn step_to(&self, area: Double, root_of_half_slope: f64) -> f64 {
        let rest = gap(area, self.area);
        // At the end itself both are 0.
        if rest == 0.0 {
            rest
        } else {
            rest / (2.0 * root_of_half_slope * root_of_half_slope)
        }
    }

    /// (cos, sin) at x + d.
    #[inline(always)]
    fn turned(&self, d: f64) -> CosSin<Double> {
        let CosSin { cos, sin } = self.at;
        CosSin {
            cos: Double::fast_two_sum(cos.hi, cos.lo - sin.hi * d),
            sin: Double::fast_two_sum(sin.hi, sin.lo + cos.hi * d),
        }
    }
}

#[inline(always)]
fn tail_of_end_area(area: Double) -> Double {
    normalise(mul_raw(area, RECIP_PI))
}

#[inline(always)]
fn tail_of_axis_area(area: Double) -> Double {
    add_smaller(Double::from_f64(0.5), -mul_raw(area, RECIP_PI))
}

/// Nearer tail at |θ| = a ≤ π/2.
#[inline]
pub(crate) fn tail_at_angle(a: f64) -> Double {
    if a > QUARTER_PI.hi {
        tail_of_end_area(Arc::from_end(from_end(a)).area)
    } else {
        tail_of_axis_area(Arc::from_axis(Double::from_f64(a)).area)
    }
}

/// Nearer tail at a direction, from the smaller of cos θ and |sin θ|.
#[inline]
pub(crate) fn tail_at_direction(cos: Double, sin: Double) -> Double {
    let at_end = cos.hi <= sin.hi;
    let small = if at_end { cos } else { sin };
    let start = Double::from_f64(libm::asin(small.hi));
    if at_end {
        let arc = Arc::from_end(start);
        let d = gap(small, arc.at.sin) / arc.at.cos.hi;
        tail_of_end_area(arc.area_beyond(arc.at.sin.hi, d))
    } else {
        let arc = Arc::from_axis(start);
        let d = gap(small, arc.at.sin) / arc.at.cos.hi;
        tail_of_axis_area(arc.area_beyond(arc.at.cos.hi, d))
    }
}

/// The f64 solution at the nearer tail p, Newton's step from it, and whether it is from the end.
#[inline(always)]
fn corrected(p: Double) -> (f64, Arc, f64, bool) {
    let table = &f64::TABLE;
    if p.hi < 0.125 {
        let s = cbrt_times(<f64 as Native>::CONSTANTS.twelve_pi, p.hi);
        let t = s * s;
        let start = s * 0.5 + s * t * horner(t, table.kepler_tail);
        let arc = Arc::from_end(Double::from_f64(start));
        let step = arc.step_to(mul_raw(p, PI), arc.at.sin.hi);
        (start, arc, step, true)
    } else {
        // From the pair's ½ − p: near ½ it is all that p holds.
        let d = sum(Double::from_f64(0.5), -p);
        let w = d.hi * d.hi;
        let start =
            d.hi * (<f64 as Native>::CONSTANTS.half_pi.hi + w * horner(w, table.kepler_centre));
        let arc = Arc::from_axis(Double::from_f64(start));
        let step = arc.step_to(mul_raw(d, PI), arc.at.cos.hi);
        (start, arc, step, false)
    }
}

/// The angle at the nearer tail p: from the end where p < ⅛ (`true`), else from the axis.
#[inline]
pub(crate) fn angle_at_tail(p: Double) -> (Double, bool) {
    let (start, _, step, at_end) = corrected(p);
    (Double::fast_two_sum(start, step), at_end)
}

/// (cos θ, |sin θ|) at the nearer tail p.
#[inline]
pub(crate) fn direction_at_tail(p: Double) -> CosSin<Double> {
    let (_, arc, step, at_end) = corrected(p);
    let at = arc.turned(step);
    if at_end { swapped(at) } else { at }
}
