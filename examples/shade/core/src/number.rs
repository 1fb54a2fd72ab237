//! What the shader asks of a number type beyond what the laws do.

use coslobe::uniform::TailBits;
use coslobe::{Fast, Precise, Real};

/// A number type of `coslobe` that scenes are rendered in.
///
/// Geometry is computed in the format's own arithmetic whatever the tier: the tier decides how
/// exact the laws are. Exponentials and logarithms (fog alone asks for them) are `libm`'s of the
/// format.
pub trait Number: Real + Into<f64> {
    /// As in `coslobe`'s documentation.
    const NAME: &'static str;
    /// π.
    const PI: Self;
    /// Half the distance from 1 to the next number: the relative error of one operation.
    const ROUNDING: Self;
    /// Whether the laws' pairs are unit vectors to fewer digits than geometry needs.
    const IS_COARSE: bool = false;
    /// Random words of 32 bits behind a probability.
    const TAIL_WORDS: usize = size_of::<TailBits<Self>>() / 4;
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
    const NAME: &'static str = "f32";
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
    const NAME: &'static str = "f64";
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
    const NAME: &'static str = "Fast<f32>";
    const PI: Self = Fast(core::f32::consts::PI);
    const ROUNDING: Self = Fast(<f32 as Number>::ROUNDING);
    const IS_COARSE: bool = true;
    const TAIL_WORDS: usize = 1;
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
    const NAME: &'static str = "Precise<f32>";
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

/// What others' pictures are compared with.
impl Number for Precise<f64> {
    const NAME: &'static str = "Precise<f64>";
    const PI: Self = Precise(core::f64::consts::PI);
    const ROUNDING: Self = Precise(<f64 as Number>::ROUNDING);
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Precise(x)
    }
    #[inline(always)]
    fn from_f32(x: f32) -> Self {
        Precise(f64::from(x))
    }
    #[inline(always)]
    fn root(self) -> Self {
        Precise(libm::sqrt(self.0))
    }
    #[inline]
    fn exp(self) -> Self {
        Precise(libm::exp(self.0))
    }
    #[inline]
    fn ln(self) -> Self {
        Precise(libm::log(self.0))
    }
}

/// Is shown number types.
pub trait NumberVisitor {
    /// One of them.
    fn number<T: Number>(&mut self);
}

/// Shows every number type, from the coarsest to the most exact.
pub fn every_number(visitor: &mut impl NumberVisitor) {
    visitor.number::<Fast<f32>>();
    visitor.number::<f32>();
    visitor.number::<Precise<f32>>();
    visitor.number::<f64>();
    visitor.number::<Precise<f64>>();
}
