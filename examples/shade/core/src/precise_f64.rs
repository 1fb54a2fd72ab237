//! The most exact type of all: what others' pictures are compared with.

use crate::Number;
use coslobe::Precise;

impl Number for Precise<f64> {
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
