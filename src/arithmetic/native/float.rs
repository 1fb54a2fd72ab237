//! A hardware format by its operations.

use crate::scalar::Scalar;

/// `f32` or `f64`: a format whose operations round to nearest.
pub trait Float: Scalar {
    /// Half the format's significand: below it 1 − x²/2 is 1 to twice the precision.
    const NEGLIGIBLE: Self;
    /// A power of 4 that makes every subnormal normal, and the inverse of its root.
    const ROOT_UP: Self;
    const ROOT_DOWN: Self;
    /// A cube root is taken of x·`CBRT_UP`, normal for every x > 0, and scaled back by `CBRT_DOWN`.
    const CBRT_UP: Self;
    const CBRT_DOWN: Self;
    /// Newton steps of the cube root after its first step.
    const CBRT_STEPS: usize;
    /// ⅓, 2/9 and 14/81.
    const CBRT_THIRD: Self;
    const CBRT_SECOND: Self;
    const CBRT_FOURTH: Self;
    /// 1 and half the last place that `leading_half` keeps of it.
    const CBRT_RAISE: Self;

    /// Truncated; for 0 ≤ x < 2³¹.
    fn to_u32(self) -> u32;
    fn to_i32(self) -> i32;
    fn from_i32(n: i32) -> Self;

    fn ln(self) -> Self;
    fn ln_1p(self) -> Self;
    fn exp(self) -> Self;
    fn exp_m1(self) -> Self;

    /// self·2ⁿ, rounded once.
    fn scale(self, n: i32) -> Self;
    /// (m, e) with self = m·2ᵉ and m from √½ to √2, for finite self > 0.
    fn split(self) -> (Self, i32);
    /// The leading half of the significand's bits.
    fn leading_half(self) -> Self;
    /// 1/∛self to about 5 bits, for normal self > 0.
    fn cbrt_recip_guess(self) -> Self;
}
