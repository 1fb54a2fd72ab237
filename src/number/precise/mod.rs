//! `Precise`: the same format, with every result rounded from wider arithmetic.

mod f32;
mod f64;

use crate::scalar::Scalar;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The most accurate tier of a format: the laws' results are rounded once, from wider arithmetic.
///
/// `Precise<f32>` is correctly rounded: every operation of the six laws without a parameter gives
/// the `f32` nearest to the true value (of angles, the nearest in the support). It is computed in
/// `f64` with a rounding test, and in double-double where the test cannot decide. `Precise<f64>`
/// is computed in double-double; where `f64`'s exponents do not reach, with an exponent of its
/// own.
///
/// Its own `+ − × ÷` are those of the format. Randomness as the plain format's, with the same
/// uniforms: the `f32` sample is the `Precise<f32>` sample of the same words with a few more
/// roundings. What the digits cost is in the tables of [`accuracy`](crate::accuracy).
///
/// ```
/// use coslobe::{Disk, Law, Precise};
/// assert_eq!(Disk.cdf(Precise(0.0f32)).0, 0.5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Precise<T>(pub T);

impl<T: Add<Output = T>> Add for Precise<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Precise(self.0 + b.0)
    }
}

impl<T: Sub<Output = T>> Sub for Precise<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Precise(self.0 - b.0)
    }
}

impl<T: Mul<Output = T>> Mul for Precise<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Precise(self.0 * b.0)
    }
}

impl<T: Div<Output = T>> Div for Precise<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        Precise(self.0 / b.0)
    }
}

impl<T: Neg<Output = T>> Neg for Precise<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Precise(-self.0)
    }
}

impl<T: Scalar> Scalar for Precise<T> {
    const ZERO: Self = Precise(T::ZERO);
    const QUARTER: Self = Precise(T::QUARTER);
    const HALF: Self = Precise(T::HALF);
    const ONE: Self = Precise(T::ONE);
    const INFINITY: Self = Precise(T::INFINITY);
    const NAN: Self = Precise(T::NAN);
    const MIN_NORMAL: Self = Precise(T::MIN_NORMAL);
    const MAX: Self = Precise(T::MAX);
    const HALF_PI_DOWN: Self = Precise(T::HALF_PI_DOWN);

    #[inline(always)]
    fn int(n: i16) -> Self {
        Precise(T::int(n))
    }
    #[inline(always)]
    fn is_nan(self) -> bool {
        self.0.is_nan()
    }
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Precise(self.0.abs())
    }
    #[inline(always)]
    fn sign_bit(self) -> u32 {
        self.0.sign_bit()
    }
    #[inline(always)]
    fn swap_if_odd(n: u32, a: Self, b: Self) -> (Self, Self) {
        let (a, b) = T::swap_if_odd(n, a.0, b.0);
        (Precise(a), Precise(b))
    }
    #[inline(always)]
    fn negate_if_odd(self, n: u32) -> Self {
        Precise(self.0.negate_if_odd(n))
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Precise(self.0.copysign(sign.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Precise(self.0.sqrt())
    }
}
