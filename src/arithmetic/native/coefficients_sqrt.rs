//! Coefficients of the square root in integers, written by `python3 tools/coefficients.py`: do not edit.
//!
//! `FixedPoint`: argument in Q16, `last` in Qk, the others in Q(k + 16), `inner` with half a unit of Qk added. Each error is relative,
//! certified by Sollya's `supnorm`, of the polynomial as stored; rounding comes on top.

use super::poly::FixedPoint;

/// 1 / sqrt(1 + x); relative error 2^-13.72; k = 15
pub(crate) const RECIP_SQRT: FixedPoint<3> = FixedPoint {
    first: 2147324619,
    inner: [-1065136061, 727663842, -400258956],
    last: 1665,
};
