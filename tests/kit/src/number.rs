//! Number types by their bits.

use coslobe::{Fast, Precise, Real};

/// A number type whose bits are hashed.
pub trait Number: Real {
    /// As in the library's documentation.
    const NAME: &'static str;

    /// The pattern, the same for every NaN: processors differ in the NaN they make.
    fn bits(self) -> u64;

    /// The number of the pattern's low bits.
    fn of_bits(bits: u64) -> Self;

    /// The number of this format nearest to `x`.
    fn of(x: f64) -> Self;
}

impl Number for f32 {
    const NAME: &'static str = "f32";

    #[inline]
    fn bits(self) -> u64 {
        u64::from(if self.is_nan() {
            f32::NAN.to_bits()
        } else {
            self.to_bits()
        })
    }

    #[inline]
    fn of_bits(bits: u64) -> Self {
        f32::from_bits(bits as u32)
    }

    #[inline]
    fn of(x: f64) -> Self {
        x as f32
    }
}

impl Number for f64 {
    const NAME: &'static str = "f64";

    #[inline]
    fn bits(self) -> u64 {
        if self.is_nan() {
            f64::NAN.to_bits()
        } else {
            self.to_bits()
        }
    }

    #[inline]
    fn of_bits(bits: u64) -> Self {
        f64::from_bits(bits)
    }

    #[inline]
    fn of(x: f64) -> Self {
        x
    }
}

impl Number for Fast<f32> {
    const NAME: &'static str = "Fast<f32>";

    #[inline]
    fn bits(self) -> u64 {
        self.0.bits()
    }

    #[inline]
    fn of_bits(bits: u64) -> Self {
        Fast(f32::of_bits(bits))
    }

    #[inline]
    fn of(x: f64) -> Self {
        Fast(f32::of(x))
    }
}

impl Number for Precise<f32> {
    const NAME: &'static str = "Precise<f32>";

    #[inline]
    fn bits(self) -> u64 {
        self.0.bits()
    }

    #[inline]
    fn of_bits(bits: u64) -> Self {
        Precise(f32::of_bits(bits))
    }

    #[inline]
    fn of(x: f64) -> Self {
        Precise(f32::of(x))
    }
}

impl Number for Precise<f64> {
    const NAME: &'static str = "Precise<f64>";

    #[inline]
    fn bits(self) -> u64 {
        self.0.bits()
    }

    #[inline]
    fn of_bits(bits: u64) -> Self {
        Precise(f64::of_bits(bits))
    }

    #[inline]
    fn of(x: f64) -> Self {
        Precise(x)
    }
}
