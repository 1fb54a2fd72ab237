//! The rotation that takes +y to a normal, by products of 16 by 16 bits: the formula of
//! `q31/frame.rs`.

use super::root::half_recip;

const ONE: i32 = 1 << 15;

/// 1/(1 + |z|) in Q15.
#[inline(always)]
pub(crate) fn recip(z: i32) -> i32 {
    // 1 + |z| but for its top bit, which is not read.
    let recip = half_recip(z.unsigned_abs().min(0x7FFF) << 16) >> 16;
    ((recip >> 1).wrapping_add(recip & 1)) as i32
}

#[inline(always)]
fn towards(x: i32, sign: i32) -> i32 {
    let mask = sign >> 31;
    (x ^ mask).wrapping_sub(mask)
}

/// Q30 to the nearest of Q15.
#[inline(always)]
fn rounded(q30: i32) -> i32 {
    q30.wrapping_add(ONE >> 1) >> 15
}

/// Q30 to the nearest of Q15, ±1 saturated to one unit less.
#[inline(always)]
fn component(q30: i32) -> i32 {
    rounded(q30).clamp(1 - ONE, ONE - 1)
}

#[inline(always)]
fn product(a: i32, b: i32) -> i32 {
    a.wrapping_mul(b)
}

#[inline(always)]
pub(crate) fn to_world([x, y, z]: [i32; 3], recip: i32, [lx, ly, lz]: [i32; 3]) -> [i32; 3] {
    let lz = towards(lz, z);
    let h = product(x, lx).wrapping_sub(product(y, lz));
    let along = ly.wrapping_sub(rounded(product(recip, rounded(h))));
    [
        component((lx << 15).wrapping_add(product(x, along))),
        component(product(y, along).wrapping_sub(lz << 15)),
        component(product(z, ly).wrapping_sub(towards(h, z))),
    ]
}

#[inline(always)]
pub(crate) fn to_local([x, y, z]: [i32; 3], recip: i32, [wx, wy, wz]: [i32; 3]) -> [i32; 3] {
    let q = product(x, wx).wrapping_add(product(y, wy));
    let share = rounded(product(recip, rounded(q))).wrapping_add(towards(wz, z));
    [
        component((wx << 15).wrapping_sub(product(x, share))),
        component(q.wrapping_add(product(z, wz))),
        towards(component((wy << 15).wrapping_sub(product(y, share))), !z),
    ]
}

/// |length² − 1| in Q30.
#[inline(always)]
pub(crate) fn square_off(normal: [i32; 3]) -> u32 {
    let square = normal.map(|c| product(c, c) as u32);
    square
        .iter()
        .fold(0, |sum: u32, part| sum.wrapping_add(*part))
        .abs_diff(1 << 30)
}
