//! Number types: what whoever tests, counts or draws in one of them has to know of it.

use crate::Id;
#[cfg(feature = "std")]
pub use crate::accuracy::format::Format;
use core::f64::consts::FRAC_PI_2;
use coslobe::Real;

/// Calls of `next_u32` and of `next_u64`.
pub type Drawn = (usize, usize);

/// A format: a number type that is read as it stands. With `std` it has references.
#[cfg(not(feature = "std"))]
pub trait Format: Number<Raw = Self> {}

#[cfg(not(feature = "std"))]
impl Format for f32 {}

#[cfg(not(feature = "std"))]
impl Format for f64 {}

/// A number type: a format, `Raw`, read with the accuracy that the type's name says.
pub trait Number: Real + Into<f64> {
    /// `f32` or `f64`.
    type Raw: Format;

    /// As in the library's documentation and its tables.
    const NAME: &'static str;

    /// Distance from 1 to the next number of the format.
    const EPSILON: f64;
    /// The unit of a direction's length: [`Number::EPSILON`], or what makes the promise of a
    /// coarser type 2 of it.
    const ULP: f64 = Self::EPSILON;
    /// How far from 1 a direction's length may be.
    const LENGTH: f64 = 2.0 * Self::ULP;
    /// Relative error of a direction's components.
    const ERROR: f64 = Self::EPSILON;
    /// Distance of neighbouring cosines, relative to them.
    const GRID: f64 = Self::EPSILON;

    /// Words of one probability.
    const TAIL_WORDS: Drawn;
    /// Words of one azimuth.
    const TURN_WORDS: Drawn;

    /// Words of θ where it is one probability, as in most laws, or two numbers.
    fn theta_words(_: Id) -> Drawn {
        Self::TAIL_WORDS
    }

    /// The least number that is told from 0.
    const LEAST_STEP: f64;
    /// The least normal number.
    const SMALLEST: Self;
    /// The largest number.
    const LARGEST: Self;
    /// The last number inside the support: the largest not above the true π/2.
    const END: Self;

    /// The format's number in this type.
    fn of_raw(raw: Self::Raw) -> Self;
    /// The number in its format.
    fn raw(self) -> Self::Raw;
    /// The number nearest to `x`.
    fn of(x: f64) -> Self;
    /// The number, exactly.
    #[inline]
    fn wide(self) -> f64 {
        self.into()
    }

    /// The pattern, the same for every NaN: processors differ in the NaN they make.
    fn bits(self) -> u64;
    /// The number of the pattern's low bits.
    fn of_bits(bits: u64) -> Self;
    /// A little more: the next number, or a unit of [`Number::ULP`].
    fn above(self) -> Self;
    /// A little less.
    fn below(self) -> Self;
    /// Whether the sign bit is set.
    fn negative(self) -> bool;
    /// Whether it is no number.
    #[inline]
    fn nan(self) -> bool {
        self.wide().is_nan()
    }
}

impl Number for f32 {
    type Raw = f32;
    const NAME: &'static str = "f32";
    const EPSILON: f64 = f32::EPSILON as f64;
    const TAIL_WORDS: Drawn = (0, 1);
    const TURN_WORDS: Drawn = (1, 0);
    const LEAST_STEP: f64 = f32::from_bits(1) as f64;
    const SMALLEST: f32 = f32::MIN_POSITIVE;
    const LARGEST: f32 = f32::MAX;
    // FRAC_PI_2 as f32 lies beyond π/2.
    const END: f32 = f32::from_bits(core::f32::consts::FRAC_PI_2.to_bits() - 1);

    #[inline]
    fn of_raw(raw: f32) -> f32 {
        raw
    }
    #[inline]
    fn raw(self) -> f32 {
        self
    }
    #[inline]
    fn of(x: f64) -> f32 {
        x as f32
    }
    #[inline]
    fn bits(self) -> u64 {
        u64::from(if self.is_nan() {
            f32::NAN.to_bits()
        } else {
            self.to_bits()
        })
    }
    #[inline]
    fn of_bits(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }
    fn above(self) -> f32 {
        self.next_up()
    }
    fn below(self) -> f32 {
        self.next_down()
    }
    fn negative(self) -> bool {
        self.is_sign_negative()
    }
}

impl Number for f64 {
    type Raw = f64;
    const NAME: &'static str = "f64";
    const EPSILON: f64 = f64::EPSILON;
    const TAIL_WORDS: Drawn = (0, 2);
    const TURN_WORDS: Drawn = (0, 1);
    const LEAST_STEP: f64 = f64::from_bits(1);
    const SMALLEST: f64 = f64::MIN_POSITIVE;
    const LARGEST: f64 = f64::MAX;
    const END: f64 = FRAC_PI_2;

    #[inline]
    fn of_raw(raw: f64) -> f64 {
        raw
    }
    #[inline]
    fn raw(self) -> f64 {
        self
    }
    #[inline]
    fn of(x: f64) -> f64 {
        x
    }
    #[inline]
    fn bits(self) -> u64 {
        if self.is_nan() {
            f64::NAN.to_bits()
        } else {
            self.to_bits()
        }
    }
    #[inline]
    fn of_bits(bits: u64) -> f64 {
        f64::from_bits(bits)
    }
    fn above(self) -> f64 {
        self.next_up()
    }
    fn below(self) -> f64 {
        self.next_down()
    }
    fn negative(self) -> bool {
        self.is_sign_negative()
    }
}
