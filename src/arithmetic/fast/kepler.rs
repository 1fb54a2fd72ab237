//! The tail of the disk's law and its inverse.
//!
//! With z = ∛p, cos θ/z is analytic in z² and |sin θ|/d, d = ½ − p, is analytic in z, over the
//! whole half range: cos θ has all its digits at the end and sin θ at the axis, with no iteration
//! and no choice between branches.

use super::angle::from_end;
use super::coefficients::{
    KEPLER_ANGLE, KEPLER_COS, KEPLER_MIDDLE, KEPLER_SIN, TAIL_OF_ANGLE, TAIL_OF_SINE,
};
use super::fixed::{at_most_one, horner, leading_30, leading_31, q16};
use super::root::cbrt;
use core::f32::consts::PI;

/// Nearer tail of the disk's law at |θ| = a ≤ π/2.
#[inline]
pub(crate) fn tail_at_angle(a: f32) -> f32 {
    let eta = from_end(a);
    let h = eta * eta;
    h * eta * horner(h, &TAIL_OF_ANGLE)
}

/// Nearer tail of the disk's law at a direction: p/cos³θ is analytic in sin θ on all of [0, 1].
#[inline]
pub(crate) fn tail_at_direction(cos: f32, sin: f32) -> f32 {
    cos * cos * cos * horner(sin, &TAIL_OF_SINE)
}

/// (cos θ, |sin θ|) at the nearer tail p ≤ ½.
#[inline]
pub(crate) fn direction_at_tail(p: f32) -> (f32, f32) {
    let z = cbrt(p);
    let x = q16(z);
    let square = ((x as u32).wrapping_mul(x as u32) >> 16) as i32;
    let cos = z * leading_31(KEPLER_COS.at(square), 0);
    let sin = (0.5 - p) * leading_30(KEPLER_SIN.at(x.wrapping_sub(KEPLER_MIDDLE)), 1);
    (at_most_one(cos), at_most_one(sin))
}

/// |θ| at the nearer tail p ≤ ½; may exceed π/2 by the error.
#[inline]
pub(crate) fn angle_at_tail(p: f32) -> f32 {
    let x = q16(cbrt(p));
    (0.5 - p) * PI * leading_30(KEPLER_ANGLE.at(x.wrapping_sub(KEPLER_MIDDLE)) << 1, 0)
}
