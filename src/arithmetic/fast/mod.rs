//! Kernels of about 2⁻¹³ relative error, for half the bits of an `f32` at a fraction of the cost.
//!
//! A polynomial is evaluated in 32-bit integers where its argument is one already (a random word, a
//! significand), in `f32` where the argument is a float: without a floating-point unit an integer
//! step is some thirty times cheaper, with one the conversion would cost as much as it saves.

pub(crate) mod angle;
pub(crate) mod coefficients;
pub(crate) mod fixed;
pub(crate) mod kepler;
pub(crate) mod kernel;
pub(crate) mod power;
pub(crate) mod root;
pub(crate) mod tail_root;
pub(crate) mod uniform;

#[cfg(test)]
mod tests;

use crate::scalar::Scalar;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The cheapest tier: relative errors of about 2⁻¹² in densities and directions.
///
/// Sums of rounding errors are not carried, polynomials are short, and a uniform is one word: a
/// target without a floating-point unit gains most. The square root is the plain type's, an
/// instruction where there is one and some fifty where there is none.
/// Directions are unit vectors to 2⁻¹², inside the support, with positive density and no component
/// beyond 1. Subnormal arguments are accepted; their accuracy is not promised. Quantiles may step
/// back within their error.
///
/// Where the plain type's operation is roots and products alone there is little to save on a host:
/// [`accuracy`](crate::accuracy)'s tables say what each costs.
///
/// Its own `+ − × ÷` are those of the format. Randomness: one `next_u32` for θ, in
/// [`Disk`](crate::Disk), [`Ball`](crate::Ball) and [`SphereShell`](crate::SphereShell) one
/// `next_u64`, whose halves are two uniforms, and one `next_u32` for the azimuth; the deepest tail
/// of a uniform is 2⁻³². Of the 64 bits of a probability that are given, the upper half is read
/// alone.
///
/// ```
/// use coslobe::{Fast, Lambert, Law};
/// let at = Lambert.warp(Fast(0.25f32));
/// assert!((at.sin.0 - 0.5).abs() < 1e-4);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(transparent))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fast<T>(pub T);

impl Add for Fast<f32> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Fast(self.0 + b.0)
    }
}

impl Sub for Fast<f32> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Fast(self.0 - b.0)
    }
}

impl Mul for Fast<f32> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Fast(self.0 * b.0)
    }
}

impl Div for Fast<f32> {
    type Output = Self;
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        Fast(self.0 / b.0)
    }
}

impl Neg for Fast<f32> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Fast(-self.0)
    }
}

impl Scalar for Fast<f32> {
    const ZERO: Self = Fast(0.0);
    const QUARTER: Self = Fast(0.25);
    const HALF: Self = Fast(0.5);
    const ONE: Self = Fast(1.0);
    const INFINITY: Self = Fast(f32::INFINITY);
    const NAN: Self = Fast(f32::NAN);
    const MIN_NORMAL: Self = Fast(f32::MIN_POSITIVE);
    const MAX: Self = Fast(f32::MAX);
    const HALF_PI_DOWN: Self = Fast(f32::HALF_PI_DOWN);

    #[inline(always)]
    fn int(n: i16) -> Self {
        Fast(f32::from(n))
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
        Fast(self.0.abs())
    }
    #[inline(always)]
    fn sign_bit(self) -> u32 {
        self.0.sign_bit()
    }
    #[inline(always)]
    fn swap_if_odd(n: u32, a: Self, b: Self) -> (Self, Self) {
        let (a, b) = f32::swap_if_odd(n, a.0, b.0);
        (Fast(a), Fast(b))
    }
    #[inline(always)]
    fn negate_if_odd(self, n: u32) -> Self {
        Fast(self.0.negate_if_odd(n))
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Fast(self.0.copysign(sign.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Fast(Scalar::sqrt(self.0))
    }
    #[inline(always)]
    fn probability(self) -> Self {
        Fast(self.0.probability())
    }
    #[inline(always)]
    fn probabilities(a: Self, b: Self) -> (Self, Self) {
        // Of b as it is, −0 too, a minimum is one instruction.
        (Fast(f32::probabilities(a.0, b.0).0), b)
    }
}
