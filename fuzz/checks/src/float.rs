//! What the checks need of a format beyond the sealed `Real`.

use coslobe::{CosSin, Fast, Precise, Real};

/// A number type. The names differ from those of the sealed trait's own items on purpose.
pub trait Float: Real {
    /// Distance from 1 to the next number above: the unit of all bounds.
    const ULP: f64;
    /// The smallest positive number, as an absolute slack where a result is subnormal.
    const SMALLEST: f64;
    /// The smallest positive normal number.
    const NORMAL: f64;
    const LARGEST: f64;
    /// The last number inside the support: the largest not above the true π/2.
    const END: Self;

    /// The number with these bits (`f32`: the low half).
    fn from_word(word: u64) -> Self;
    /// Rounded to nearest.
    fn narrow(x: f64) -> Self;
    fn wide(self) -> f64;
    fn word(self) -> u64;
    fn above(self) -> Self;
    fn below(self) -> Self;
    fn negative(self) -> bool;

    /// A number in [0, 1], evenly spread.
    fn unit(word: u64) -> Self {
        Self::narrow(word as f64 * 2f64.powi(-64))
    }

    /// The word read both ways: as bits, and as an even spread over [low, high].
    fn both(word: u64, low: f64, high: f64) -> [Self; 2] {
        let spread = low + (high - low) * Self::unit(word).wide();
        [Self::from_word(word), Self::narrow(spread)]
    }

    fn nan(self) -> bool {
        self.wide().is_nan()
    }
}

impl Float for f32 {
    const ULP: f64 = f32::EPSILON as f64;
    const SMALLEST: f64 = f32::from_bits(1) as f64;
    const NORMAL: f64 = f32::MIN_POSITIVE as f64;
    const LARGEST: f64 = f32::MAX as f64;
    // FRAC_PI_2 as f32 lies beyond π/2.
    const END: f32 = f32::from_bits(std::f32::consts::FRAC_PI_2.to_bits() - 1);

    fn from_word(word: u64) -> f32 {
        f32::from_bits(word as u32)
    }
    fn narrow(x: f64) -> f32 {
        x as f32
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    fn word(self) -> u64 {
        u64::from(self.to_bits())
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

impl Float for f64 {
    const ULP: f64 = f64::EPSILON;
    const SMALLEST: f64 = f64::from_bits(1);
    const NORMAL: f64 = f64::MIN_POSITIVE;
    const LARGEST: f64 = f64::MAX;
    const END: f64 = std::f64::consts::FRAC_PI_2;

    fn from_word(word: u64) -> f64 {
        f64::from_bits(word)
    }
    fn narrow(x: f64) -> f64 {
        x
    }
    fn wide(self) -> f64 {
        self
    }
    fn word(self) -> u64 {
        self.to_bits()
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

/// Held to what the plain type keeps; `docs/bounds.md` has its own, tighter bounds.
impl<T: Float> Float for Precise<T>
where
    Precise<T>: Real,
{
    const ULP: f64 = T::ULP;
    const SMALLEST: f64 = T::SMALLEST;
    const NORMAL: f64 = T::NORMAL;
    const LARGEST: f64 = T::LARGEST;
    const END: Self = Precise(T::END);

    fn from_word(word: u64) -> Self {
        Precise(T::from_word(word))
    }
    fn narrow(x: f64) -> Self {
        Precise(T::narrow(x))
    }
    fn wide(self) -> f64 {
        self.0.wide()
    }
    fn word(self) -> u64 {
        self.0.word()
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

/// As if it had 14 bits, so that a direction's 2⁻¹² are 2 ulp, and no subnormal numbers.
impl Float for Fast<f32> {
    const ULP: f64 = 1.0 / 8192.0;
    const SMALLEST: f64 = f32::MIN_POSITIVE as f64;
    const NORMAL: f64 = f32::MIN_POSITIVE as f64;
    const LARGEST: f64 = f32::MAX as f64;
    const END: Self = Fast(<f32 as Float>::END);

    fn from_word(word: u64) -> Self {
        Fast(f32::from_word(word))
    }
    fn narrow(x: f64) -> Self {
        Fast(x as f32)
    }
    fn wide(self) -> f64 {
        f64::from(self.0)
    }
    fn word(self) -> u64 {
        self.0.word()
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

/// The pair at θ to about an ulp, from the standard library.
pub(super) fn pair_at<T: Float>(theta: f64) -> CosSin<T> {
    CosSin {
        cos: T::narrow(theta.cos()),
        sin: T::narrow(theta.sin()),
    }
}
