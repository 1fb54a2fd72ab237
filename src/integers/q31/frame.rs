//! The rotation that takes +y to a normal, by eight long products and a reciprocal.
//!
//! With s the sign of z, the columns of Duff et al.'s basis (JCGT 6(1), 2017) are
//! (1 − x²/(1 + |z|), −xy/(1 + |z|), −sx), the normal (x, y, z) itself, and
//! (sxy/(1 + |z|), −s(1 − y²/(1 + |z|)), y). A matrix is never formed: what both other columns
//! share is h = x·lx − s·y·lz and m = h/(1 + |z|), with which
//!
//! > world = (lx + x (ly − m), −s·lz + y (ly − m), z·ly − s·h)

use super::recip::half_recip;
use crate::integers::kernel::mul::mul_high_signed;

/// 1/(1 + |z|) in Q31, at most 1 less one unit.
#[inline(always)]
pub(crate) fn recip(z: i32) -> i32 {
    (half_recip((1 << 31) | z.unsigned_abs().min(i32::MAX as u32)) >> 1) as i32
}

/// `x` with the sign of `sign`: −x for a negative one.
#[inline(always)]
fn towards(x: i32, sign: i32) -> i32 {
    let mask = sign >> 31;
    (x ^ mask).wrapping_sub(mask)
}

/// 2·`half` and a last bit, ±1 saturated to one unit less.
#[inline(always)]
fn doubled(half: i32, last: i32) -> i32 {
    const MOST: i32 = (1 << 30) - 1;
    let most = half.clamp(MOST.wrapping_neg(), MOST);
    (most << 1) | ((last & 1) & i32::from(most == half))
}

/// a + b (c − d) in Q31, |c − d| ≤ √2: half of it first, which cannot overflow.
#[inline(always)]
fn sum(a: i32, b: i32, c: i32, d: i32) -> i32 {
    let change = mul_high_signed(b, c).wrapping_sub(mul_high_signed(b, d));
    doubled((a >> 1).wrapping_add(change), a)
}

/// From local axes, +y along `normal`, to the world's; `recip` = 1/(1 + |z|). All in Q31, none −1.
#[inline(always)]
pub(crate) fn to_world([x, y, z]: [i32; 3], recip: i32, [lx, ly, lz]: [i32; 3]) -> [i32; 3] {
    let lz = towards(lz, z);
    let h = mul_high_signed(x, lx).wrapping_sub(mul_high_signed(y, lz));
    let m = doubled(mul_high_signed(recip, doubled(h, 0)), 1);
    [
        sum(lx, x, ly, m),
        sum(lz.wrapping_neg(), y, ly, m),
        doubled(mul_high_signed(z, ly).wrapping_sub(towards(h, z)), 1),
    ]
}

/// From the world's axes to local ones: the inverse.
///
/// With q = x·wx + y·wy and g = q/(1 + |z|) + s·wz it is
/// (wx − x·g, q + z·wz, −s (wy − y·g)).
#[inline(always)]
pub(crate) fn to_local([x, y, z]: [i32; 3], recip: i32, [wx, wy, wz]: [i32; 3]) -> [i32; 3] {
    let q = mul_high_signed(x, wx).wrapping_add(mul_high_signed(y, wy));
    let share = doubled(mul_high_signed(recip, doubled(q, 0)), 1);
    let back = towards(wz, z).wrapping_neg();
    [
        sum(wx, x, back, share),
        doubled(q.wrapping_add(mul_high_signed(z, wz)), 1),
        towards(sum(wy, y, back, share), !z),
    ]
}

/// |length² − 1| in Q30.
#[inline(always)]
pub(crate) fn square_off(normal: [i32; 3]) -> u32 {
    let square = normal.map(|c| mul_high_signed(c, c) as u32);
    square
        .iter()
        .fold(0, |sum: u32, part| sum.wrapping_add(*part))
        .abs_diff(1 << 30)
}
