//! Number types: a format and an accuracy tier at once, one a file.

mod f32;
mod f64;

/// A number type that the laws work in: [`prim@f32`] or [`prim@f64`].
///
/// Sealed. Each type brings its constants, its polynomials and the few primitive kernels; every
/// law is written once on top of them. `f32` is computed in `f32` alone, on every target.
pub trait Real: kernel::Kernel {}

pub(crate) mod kernel {
    use crate::kernel::table::Table;
    use crate::{CosSin, Tails};
    use core::fmt::Debug;
    use core::ops::{Add, Div, Mul, Neg, Sub};
    use rand_core::Rng;

    /// What a format must provide. All of it is total and branch-light.
    pub trait Kernel:
        Copy
        + Debug
        + Default
        + PartialOrd
        + Add<Output = Self>
        + Sub<Output = Self>
        + Mul<Output = Self>
        + Div<Output = Self>
        + Neg<Output = Self>
        + Send
        + Sync
        + 'static
    {
        const TABLE: Table<Self>;
        const ZERO: Self;
        const QUARTER: Self;
        const HALF: Self;
        const ONE: Self;
        const INFINITY: Self;
        const NAN: Self;
        const MIN_NORMAL: Self;
        const MAX: Self;
        /// The largest number that is not above the true π/2.
        const HALF_PI_DOWN: Self;
        /// Half the format's significand: below it 1 − x²/2 is 1 to twice the precision.
        const NEGLIGIBLE: Self;
        /// A power of 4 that makes every subnormal normal, and the inverse of its root.
        const ROOT_UP: Self;
        const ROOT_DOWN: Self;
        /// Below this, a cube root is taken of x·`CBRT_UP` and scaled back by `CBRT_DOWN`.
        const CBRT_TINY: Self;
        const CBRT_UP: Self;
        const CBRT_DOWN: Self;
        const CBRT_STEPS: usize;

        /// Random bits behind one [`Tails`].
        type TailBits: Copy;
        /// Random bits behind one azimuth.
        type TurnBits: Copy;

        fn draw_tail_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TailBits;
        fn draw_turn_bits<R: Rng + ?Sized>(rng: &mut R) -> Self::TurnBits;
        fn tails_of(bits: Self::TailBits) -> Tails<Self>;
        fn turn_of(bits: Self::TurnBits) -> CosSin<Self>;

        fn int(n: i16) -> Self;
        /// Truncated; for 0 ≤ x < 2³¹.
        fn to_u32(self) -> u32;
        fn to_i32(self) -> i32;
        fn of_i32(n: i32) -> Self;
        fn is_nan(self) -> bool;
        fn is_finite(self) -> bool;
        fn abs(self) -> Self;
        /// `a` if `first`, else `b`, by masking bits: random bits choose, and a branch on them
        /// would be mispredicted half the time.
        fn select(first: bool, a: Self, b: Self) -> Self;
        /// −self if `negative`.
        fn negate_if(self, negative: bool) -> Self;
        fn copysign(self, sign: Self) -> Self;
        fn sqrt(self) -> Self;
        fn ln(self) -> Self;
        fn ln_1p(self) -> Self;
        fn exp(self) -> Self;
        fn exp_m1(self) -> Self;
        /// atan2(self, x).
        fn atan2(self, x: Self) -> Self;
        /// self·2ⁿ, rounded once.
        fn scale(self, n: i32) -> Self;
        /// (m, e) with self = m·2ᵉ and m from √½ to √2, for finite self > 0.
        fn split(self) -> (Self, i32);
        /// The leading half of the significand's bits.
        fn leading_half(self) -> Self;
        /// ∛self to about 5 bits, for normal self > 0.
        fn cbrt_guess(self) -> Self;
    }
}
