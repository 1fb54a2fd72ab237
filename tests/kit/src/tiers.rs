//! The number types that are more exact than their format's operations, or less.

use crate::{Drawn, Format, Id, Number};
use coslobe::{Fast, Precise, Real};

/// Whether the number type of this name promises ulps and order; `Fast` promises a relative error
/// of 2⁻¹² instead.
pub fn promises_ulps(name: &str) -> bool {
    name != Fast::<f32>::NAME
}

/// Held to what the plain type keeps; `docs/bounds.md` has its own, tighter bounds.
impl<T: Format> Number for Precise<T>
where
    Precise<T>: Real + Into<f64>,
{
    type Raw = T;
    const NAME: &'static str = if size_of::<T>() == 4 {
        "Precise<f32>"
    } else {
        "Precise<f64>"
    };
    const EPSILON: f64 = T::EPSILON;
    const TAIL_WORDS: Drawn = T::TAIL_WORDS;
    const TURN_WORDS: Drawn = T::TURN_WORDS;
    const LEAST_STEP: f64 = T::LEAST_STEP;
    const SMALLEST: Self = Precise(T::SMALLEST);
    const LARGEST: Self = Precise(T::LARGEST);
    const END: Self = Precise(T::END);

    #[inline]
    fn of_raw(raw: T) -> Self {
        Precise(raw)
    }
    #[inline]
    fn raw(self) -> T {
        self.0
    }
    #[inline]
    fn of(x: f64) -> Self {
        Precise(T::of(x))
    }
    #[inline]
    fn bits(self) -> u64 {
        self.0.bits()
    }
    #[inline]
    fn of_bits(bits: u64) -> Self {
        Precise(T::of_bits(bits))
    }
    fn above(self) -> Self {
        Precise(self.0.above())
    }
    fn below(self) -> Self {
        Precise(self.0.below())
    }
    fn negative(self) -> bool {
        self.0.negative()
    }
}

/// As if it had 14 bits and no subnormal numbers.
impl Number for Fast<f32> {
    type Raw = f32;
    const NAME: &'static str = "Fast<f32>";
    const EPSILON: f64 = f32::EPSILON as f64;
    const ULP: f64 = 1.0 / 8192.0;
    const ERROR: f64 = 1.0 / 4096.0;
    const GRID: f64 = 1.0 / 32768.0; // its cube root has 16 bits
    const TAIL_WORDS: Drawn = (1, 0);
    const TURN_WORDS: Drawn = (1, 0);
    fn theta_words(law: Id) -> Drawn {
        if law.has_two_uniforms() {
            (0, 1)
        } else {
            Self::TAIL_WORDS
        }
    }
    const LEAST_STEP: f64 = f32::MIN_POSITIVE as f64;
    const SMALLEST: Self = Fast(f32::MIN_POSITIVE);
    const LARGEST: Self = Fast(f32::MAX);
    const END: Self = Fast(<f32 as Number>::END);

    #[inline]
    fn of_raw(raw: f32) -> Self {
        Fast(raw)
    }
    #[inline]
    fn raw(self) -> f32 {
        self.0
    }
    #[inline]
    fn of(x: f64) -> Self {
        Fast(x as f32)
    }
    #[inline]
    fn bits(self) -> u64 {
        self.0.bits()
    }
    #[inline]
    fn of_bits(bits: u64) -> Self {
        Fast(f32::of_bits(bits))
    }
    fn above(self) -> Self {
        Fast((self.0 + (self.0 * Self::ULP as f32).abs()).next_up())
    }
    fn below(self) -> Self {
        -(-self).above()
    }
    fn negative(self) -> bool {
        self.0.is_sign_negative()
    }
}
