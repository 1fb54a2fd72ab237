//! A hardware format by its operations.

use crate::scalar::Scalar;

/// `f32` or `f64`: a format whose operations round to nearest.
pub trait Float: Scalar {
    /// Half the format's significand: below it 1 − x²/2 is 1 to twice the precision.
    const NEGLIGIBLE: Self;
    /// A power of 4 that makes every subnormal normal, and the inverse of its root.
    const ROOT_UP: Self;
    const ROOT_DOWN: Self;
    /// The exponent of `ROOT_UP`.
    const ROOT_EXPONENT: i32;
    /// A cube root is taken of x·`CBRT_UP`, normal for every x > 0, and scaled back by `CBRT_DOWN`.
    const CBRT_UP: Self;
    const CBRT_DOWN: Self;
    /// Newton steps of the cube root after its first step.
    const CBRT_STEPS: usize;
    /// ⅓, 2/9 and 14/81.
    const CBRT_THIRD: Self;
    const CBRT_SECOND: Self;
    const CBRT_FOURTH: Self;
    /// 1 plus half the last place that `leading_half` keeps of 1.
    const CBRT_RAISE: Self;

    /// 2ⁿ whose last place is ¼.
    const COUNTS_QUARTERS: Self;

    /// √½, where a significand is split off a logarithm.
    const ROOT_HALF: Self;
    /// Sines below `TINY_SINE` are squared times `TINY_UP`; `TINY_SHARE` is ½ over its square.
    const TINY_SINE: Self;
    const TINY_UP: Self;
    const TINY_SHARE: Self;
    /// 2ʸ − 1 is y ln 2 for y below it.
    const SLIGHT: Self;
    /// 2ʸ is 0 or ∞ beyond, whatever it is multiplied with.
    const EXPONENT_LIMIT: Self;
    /// The least exponent of a normal number, and nearly its double.
    const LEAST_EXPONENT: i32;
    const TWICE_EXPONENT: i32;
    /// Factors below `LIFT_BELOW` are multiplied by `LIFT` = 2 to the `LIFT_EXPONENT`; `DROP` is
    /// 1/`LIFT`.
    const LIFT_BELOW: Self;
    const LIFT: Self;
    const DROP: Self;
    /// √`DROP`.
    const ROOT_DROP: Self;
    const LIFT_EXPONENT: i32;
    /// The cube of a logarithm's argument counts beyond the format.
    const EXACT_CUBE: bool;

    /// The lower bits of the pattern.
    fn last_bits(self) -> u32;
    /// Truncated; for 0 ≤ x < 2³¹.
    fn to_u32(self) -> u32;
    fn from_i32(n: i32) -> Self;

    fn ln(self) -> Self;
    fn ln_1p(self) -> Self;

    /// self·2ⁿ, rounded once.
    fn scale(self, n: i32) -> Self;
    /// The nearest whole number, twice; some number beyond ±2²¹.
    fn nearest(self) -> (Self, i32);
    /// 2ⁿ for an exponent n of the format's normal numbers; some number for others.
    fn exp2(n: i32) -> Self;
    /// As [`split`](Float::split), for normal self alone.
    fn split_normal(self, least: Self) -> (Self, i32);
    /// (m, e) with self = m·2ᵉ and m from `least` to twice that, for finite self > 0; some numbers
    /// for others.
    fn split(self, least: Self) -> (Self, i32);
    /// The leading half of the significand's bits.
    fn leading_half(self) -> Self;
    /// As many leading bits as leave their cube exact where that counts, or half of all.
    fn cube_head(self) -> Self;
    /// So many leading bits that the product with an exponent of the format is exact.
    fn exponent_factor(self) -> Self;
    /// 1/∛self to about 5 bits, for normal self > 0.
    fn cbrt_recip_guess(self) -> Self;
}
