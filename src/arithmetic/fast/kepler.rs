//! The tail of the disk's law and its inverse.
//!
//! Beside the end cos θ is an odd function of z = ∛p and |sin θ| an even one; beside the axis
//! |sin θ| is odd in d = ½ − p and cos θ even. So each has all its digits where it vanishes, by
//! short polynomials and no iteration, and about the axis no root is taken.

use super::angle::from_end;
use super::coefficients::{
    CENTRE_ANGLE, CENTRE_COS, CENTRE_SIN, END_ANGLE, END_COS, END_SIN, KEPLER_SPLIT, TAIL_OF_ANGLE,
    TAIL_OF_SINE,
};
use super::fixed::{FixedPoint, at_most_one, horner, leading_30, leading_31, truncated};
use super::root::cbrt_by;
use crate::scalar::{BY_SELECTS, Scalar};

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

/// Whether a direction is measured from the end; of NaN either.
#[inline(always)]
fn beside_end(p: f32) -> bool {
    (p.to_bits() as i32) < KEPLER_SPLIT.to_bits() as i32
}

/// (q, x² in Q16): beside the end q = x = ∛p, else q = ½ − p and x = 2q.
#[inline(always)]
fn place<const SELECTS: bool>(is_end: bool, p: f32) -> (f32, i32) {
    let q = if is_end {
        cbrt_by::<SELECTS>(p)
    } else {
        0.5 - p
    };
    let x = truncated(q, if is_end { 16 } else { 17 }) as u32;
    // By selects the compiler sees that all factors have 16 bits, as vectors need it.
    let x = if SELECTS { x & 0xFFFF } else { x };
    let square = x.wrapping_mul(x) >> 16;
    (q, if SELECTS { square & 0x7FFF } else { square } as i32)
}

/// At x² the polynomial for the end or that for the axis: by selects its coefficients are chosen,
/// so that one is worked out.
#[inline(always)]
fn either<const SELECTS: bool>(
    is_end: bool,
    end: &FixedPoint<2>,
    centre: &FixedPoint<2>,
    square: i32,
) -> u32 {
    if SELECTS {
        let mask = -i32::from(is_end);
        let of = |a: i32, b: i32| b.wrapping_add(a.wrapping_sub(b) & mask);
        FixedPoint {
            first: of(end.first as i32, centre.first as i32) as u32,
            inner: [0, 1].map(|i| of(end.inner[i], centre.inner[i])),
            last: of(end.last, centre.last),
        }
        .at(square)
    } else if is_end {
        end.at(square)
    } else {
        centre.at(square)
    }
}

/// (cos θ, |sin θ|) at the nearer tail p ≤ ½.
#[inline]
pub(crate) fn direction_at_tail(p: f32) -> (f32, f32) {
    direction_at_tail_by::<BY_SELECTS>(p)
}

#[inline(always)]
pub(super) fn direction_at_tail_by<const SELECTS: bool>(p: f32) -> (f32, f32) {
    if !SELECTS && p.to_bits() > 0.5f32.to_bits() {
        return (p, p);
    }
    let is_end = beside_end(p);
    let (q, square) = place::<SELECTS>(is_end, p);
    let odd = q * leading_31(either::<SELECTS>(is_end, &END_COS, &CENTRE_SIN, square), 0);
    let even = either::<SELECTS>(is_end, &END_SIN, &CENTRE_COS, square);
    let even = at_most_one(leading_30(even << 1, 0));
    let even = if SELECTS {
        f32::select(p <= 0.5, even, p)
    } else {
        even
    };
    f32::swap_if_odd(u32::from(is_end), even, odd)
}

/// |θ| at the nearer tail p ≤ ½.
#[inline]
pub(crate) fn angle_at_tail(p: f32) -> f32 {
    angle_at_tail_by::<BY_SELECTS>(p)
}

#[inline(always)]
pub(super) fn angle_at_tail_by<const SELECTS: bool>(p: f32) -> f32 {
    let is_end = beside_end(p);
    let (q, square) = place::<SELECTS>(is_end, p);
    if is_end {
        f32::HALF_PI_DOWN - q * leading_31(END_ANGLE.at(square), 0)
    } else {
        q * leading_31(CENTRE_ANGLE.at(square), 0)
    }
}
