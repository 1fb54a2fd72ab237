//! (cos 2πu, sin 2πu) of an angle in turns, with no range reduction to lose digits in.

use super::poly::horner;
use crate::CosSin;
use crate::number::Real;

/// (cos 2πx, sin 2πx) for |x| ≤ 1/8. Error < 1 ulp.
#[inline]
pub(crate) fn eighth<T: Real>(x: T) -> CosSin<T> {
    let table = &T::TABLE;
    let v = x * x;
    CosSin {
        cos: T::ONE + v * horner(v, table.cos_turn),
        sin: x * table.two_pi.hi + x * (table.two_pi.lo + v * horner(v, table.sin_turn)),
    }
}

/// The pair at `quadrant`/4 + x turns, |x| ≤ 1/8.
#[inline]
pub(crate) fn at_quadrant<T: Real>(quadrant: u32, x: T) -> CosSin<T> {
    let CosSin { cos, sin } = eighth(x);
    let (c, s) = if quadrant & 1 == 0 {
        (cos, sin)
    } else {
        (-sin, cos)
    };
    if quadrant & 2 == 0 {
        CosSin { cos: c, sin: s }
    } else {
        CosSin { cos: -c, sin: -s }
    }
}

/// The pair at u turns, 0 ≤ u ≤ 1.
#[inline]
pub(crate) fn at_turn<T: Real>(u: T) -> CosSin<T> {
    let quadrant = (u * T::int(4) + T::HALF).to_u32();
    at_quadrant(quadrant, u - T::int(quadrant as i16) * T::QUARTER)
}

/// (cos, sin) of the angle πp from an end, 0 ≤ p ≤ 1/2: cos is that of the angle from the axis.
#[inline]
pub(crate) fn half_turn<T: Real>(p: T) -> CosSin<T> {
    let d = T::HALF - p;
    let near = p < T::QUARTER;
    let CosSin { cos, sin } = eighth((if near { p } else { d }) * T::HALF);
    if near {
        CosSin { cos: sin, sin: cos }
    } else {
        CosSin { cos, sin }
    }
}
