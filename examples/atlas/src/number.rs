//! What the atlas needs of a number type beyond what the crate does.

use coslobe::Real;

/// `f32` or `f64`; the functions are the standard library's, as a hand-rolled sampler would call.
pub(crate) trait Number: Real + Into<f64> {
    const NAME: &'static str;
    /// Digits of the significand in bits.
    const BITS: i32;
    /// Where the sweep of the tail begins: a round number that is not subnormal.
    const LEAST_TAIL: f64;

    fn of(x: f64) -> Self;
    fn hex(self) -> String;
    fn sin_cos(self) -> (Self, Self);
    fn asin(self) -> Self;
    fn acos(self) -> Self;
    fn powf(self, y: Self) -> Self;

    /// Half the distance from 1 to the next number.
    fn unit_roundoff() -> f64 {
        2f64.powi(-Self::BITS)
    }

    /// Distance of neighbouring numbers around x > 0.
    fn ulp(x: f64) -> f64 {
        let power_of_two = f64::from_bits(x.to_bits() & 0x7ff0_0000_0000_0000);
        power_of_two * 2.0 * Self::unit_roundoff()
    }
}

impl Number for f32 {
    const NAME: &'static str = "f32";
    const BITS: i32 = 24;
    const LEAST_TAIL: f64 = 2e-38;

    fn of(x: f64) -> f32 {
        x as f32
    }

    fn hex(self) -> String {
        format!("0x{:08x}", self.to_bits())
    }

    fn sin_cos(self) -> (f32, f32) {
        f32::sin_cos(self)
    }

    fn asin(self) -> f32 {
        f32::asin(self)
    }

    fn acos(self) -> f32 {
        f32::acos(self)
    }

    fn powf(self, y: f32) -> f32 {
        f32::powf(self, y)
    }
}

impl Number for f64 {
    const NAME: &'static str = "f64";
    const BITS: i32 = 53;
    const LEAST_TAIL: f64 = 1e-300;

    fn of(x: f64) -> f64 {
        x
    }

    fn hex(self) -> String {
        format!("0x{:016x}", self.to_bits())
    }

    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }

    fn asin(self) -> f64 {
        f64::asin(self)
    }

    fn acos(self) -> f64 {
        f64::acos(self)
    }

    fn powf(self, y: f64) -> f64 {
        f64::powf(self, y)
    }
}
