//! What the shader asks of a number type beyond what the laws do.

use coslobe::{Fast, Precise, Real};

/// A number type of `coslobe` that scenes are rendered in.
///
/// Geometry is computed in the format's own arithmetic whatever the tier: the tier decides how exact the
/// laws are. Exponentials and logarithms (fog alone asks for them) are `libm`'s of the format.
pub trait Number: Real + Into<f64> {
    /// π.
    const PI: Self;
    /// Half the distance from 1 to the next number: the relative error of one operation.
    const ROUNDING: Self;
    /// Whether the laws' pairs are unit vectors to fewer digits than geometry needs.
    const IS_COARSE: bool = false;
    /// The number nearest to `x`.
    fn from_f64(x: f64) -> Self;
    /// The number nearest to `x`, without `f64` arithmetic.
    fn from_f32(x: f32) -> Self;
    /// √self, correctly rounded.
    fn root(self) -> Self;
    /// eˣ.
    fn exp(self) -> Self;
    /// ln x.
    fn ln(self) -> Self;
}

impl Number for f32 {
    const PI: f32 = core::f32::consts::PI;
    const ROUNDING: f32 = f32::EPSILON / 2.0;
    #[inline(always)]
    fn from_f64(x: f64) -> f32 {
        x as f32
    }
    #[inline(always)]
    fn from_f32(x: f32) -> f32 {
        x
    }
    #[inline(always)]
    fn root(self) -> f32 {
        libm::sqrtf(self)
    }
    #[inline]
    fn exp(self) -> f32 {
        libm::expf(self)
    }
    #[inline]
    fn ln(self) -> f32 {
        libm::logf(self)
    }
}

impl Number for f64 {
    const PI: f64 = core::f64::consts::PI;
    const ROUNDING: f64 = f64::EPSILON / 2.0;
    #[inline(always)]
    fn from_f64(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn from_f32(x: f32) -> f64 {
        f64::from(x)
    }
    #[inline(always)]
    fn root(self) -> f64 {
        libm::sqrt(self)
    }
    #[inline]
    fn exp(self) -> f64 {
        libm::exp(self)
    }
    #[inline]
    fn ln(self) -> f64 {
        libm::log(self)
    }
}

impl Number for Fast<f32> {
    const PI: Self = Fast(core::f32::consts::PI);
    const ROUNDING: Self = Fast(<f32 as Number>::ROUNDING);
    const IS_COARSE: bool = true;
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Fast(x as f32)
    }
    #[inline(always)]
    fn from_f32(x: f32) -> Self {
        Fast(x)
    }
    #[inline(always)]
    fn root(self) -> Self {
        Fast(libm::sqrtf(self.0))
    }
    #[inline]
    fn exp(self) -> Self {
        Fast(libm::expf(self.0))
    }
    #[inline]
    fn ln(self) -> Self {
        Fast(libm::logf(self.0))
    }
}

impl Number for Precise<f32> {
    const PI: Self = Precise(core::f32::consts::PI);
    const ROUNDING: Self = Precise(<f32 as Number>::ROUNDING);
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Precise(x as f32)
    }
    #[inline(always)]
    fn from_f32(x: f32) -> Self {
        Precise(x)
    }
    #[inline(always)]
    fn root(self) -> Self {
        Precise(libm::sqrtf(self.0))
    }
    #[inline]
    fn exp(self) -> Self {
        Precise(libm::expf(self.0))
    }
    #[inline]
    fn ln(self) -> Self {
        Precise(libm::logf(self.0))
    }
}

// What sealed supertraits of `Real` have, for types that are named as an associated type.

/// 0.
#[inline(always)]
pub(crate) fn zero<T: Number>() -> T {
    T::ZERO
}
/// 1.
#[inline(always)]
pub(crate) fn one<T: Number>() -> T {
    T::ONE
}
/// ½.
#[inline(always)]
pub(crate) fn half<T: Number>() -> T {
    T::HALF
}
/// ∞.
#[inline(always)]
pub(crate) fn infinity<T: Number>() -> T {
    T::INFINITY
}
/// n.
#[inline(always)]
pub(crate) fn int<T: Number>(n: i16) -> T {
    T::int(n)
}
/// |x|.
#[inline(always)]
pub(crate) fn abs<T: Number>(x: T) -> T {
    x.abs()
}
/// The smaller of the two.
#[inline(always)]
pub(crate) fn least<T: Number>(a: T, b: T) -> T {
    if a < b { a } else { b }
}
/// |x| with the sign of `sign`.
#[inline(always)]
pub(crate) fn copysign<T: Number>(x: T, sign: T) -> T {
    x.copysign(sign)
}
