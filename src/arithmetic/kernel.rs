//! The working arithmetic of the laws' formulas.

use super::native::format::Native;
use super::scalar::Scalar;
use crate::arithmetic::native::pair::Pair;
use crate::arithmetic::native::table::Constants;
use crate::arithmetic::native::{atan, cbrt, kepler, power, root, trig, turn};
use crate::{CosSin, Tails};

/// An intermediate result with what rounding took from it, as far as the arithmetic cares.
pub trait Wide<W>: Copy {
    fn exact(x: W) -> Self;
    fn value(self) -> W;
    /// The value as far as one number holds it, without arithmetic.
    fn leading(self) -> W;
    /// a + b.
    fn sum(a: W, b: W) -> Self;
    fn neg(self) -> Self;
    /// First-order product: carries the factors' low parts but not the rounding of the product.
    fn times(self, b: Self) -> Self;
    fn mul(self, b: Self) -> Self;
    fn add(self, b: Self) -> Self;
    fn div(self, b: Self) -> Self;
    /// √self, for self that is far from under- and overflow.
    fn sqrt(self) -> W;
}

/// The kernels that laws are written on. A law's formula is written once; which arithmetic runs
/// it decides what it costs and how exact it is.
pub trait Kernel: Scalar {
    type Wide: Wide<Self>;

    const CONSTANTS: Constants<Self::Wide>;

    /// √(a·b) or √(a/b) by `f`, without losing digits where a is subnormal.
    fn sqrt_scaled(a: Self, f: impl Fn(Self) -> Self) -> Self;
    /// (∜self, √self) for self ≥ 0.
    #[inline(always)]
    fn fourth_root(self) -> (Self, Self) {
        let root = self.sqrt();
        (root.sqrt(), root)
    }
    /// ∛self for self ≥ 0.
    fn cbrt(self) -> Self;
    /// As [`cbrt`](Kernel::cbrt), with what rounding took; for self far from underflow.
    fn cbrt_wide(self) -> Self::Wide;
    /// True where 1 − x²/2 is 1 and x²'s square counts for nothing.
    fn is_negligible(self) -> bool;

    fn ln(self) -> Self;
    /// ln cos θ, from the smaller of cos θ and sin θ.
    fn ln_cos(at: CosSin<Self::Wide>) -> Self;
    /// atan2(self, x).
    fn atan2(self, x: Self) -> Self;
    /// θ of a unit vector with cos θ ≥ 0.
    #[inline(always)]
    fn angle(at: CosSin<Self>) -> Self {
        at.sin.atan2(at.cos)
    }

    /// π/2 − a for 0 ≤ a ≤ π/2, relatively accurate.
    fn from_end(a: Self) -> Self::Wide;
    /// (cos θ, |sin θ|) for |θ| ≤ π/2.
    fn at_angle(theta: Self) -> CosSin<Self::Wide>;
    /// As [`at_angle`](Kernel::at_angle), with the digits that a power of it needs.
    fn at_angle_fine(theta: Self) -> CosSin<Self::Wide>;
    /// (cos, sin) at `quadrant`/4 + x turns, |x| ≤ 1/8.
    fn at_quadrant(quadrant: u32, x: Self) -> CosSin<Self>;
    /// (cos, sin) at u turns, 0 ≤ u ≤ 1.
    fn at_turn(u: Self) -> CosSin<Self>;
    /// (cos, sin) of the angle πp from an end, 0 ≤ p ≤ ½: cos is that of the angle from the axis.
    fn half_turn(p: Self) -> CosSin<Self>;

    /// Nearer tail of the disk's law at |θ| = a ≤ π/2.
    fn disk_tail_at_angle(a: Self) -> Self;
    /// Nearer tail of the disk's law, from the smaller of cos θ and |sin θ|.
    fn disk_tail_at_pair(cos: Self, sin: Self) -> Self;
    /// (cos θ, |sin θ|) of the disk's law at nearer tail p.
    fn disk_pair_at_tail(p: Self) -> CosSin<Self>;
    /// |θ| of the disk's law at nearer tail p.
    fn disk_angle_at_tail(p: Self) -> Self;

    /// ln x for finite x > 0.
    fn ln_wide(x: Self::Wide) -> Self::Wide;
    /// k·ln cos θ for cos θ > 0.
    fn ln_cos_power(k: Self::Wide, at: CosSin<Self::Wide>) -> Self::Wide;
    /// c·eᵃ.
    fn exp_times(a: Self::Wide, c: Self::Wide) -> Self;
    /// 1 − eᵃ for a ≤ 0.
    fn one_minus_exp(a: Self::Wide) -> Self;
    /// (1 − cosⁿθ, cosⁿθ) for cos θ > 0.
    #[inline]
    fn power_tails(n: Self::Wide, at: CosSin<Self::Wide>) -> (Self, Self) {
        let a = Self::ln_cos_power(n, at);
        let upper = Self::exp_times(a, Self::Wide::exact(Self::ONE));
        (Self::one_minus_exp(a), upper)
    }
    /// (cos θ, sin θ) with cosⁿθ = the upper of the tails p.
    fn power_warp(p: Tails<Self>, n: Self::Wide) -> CosSin<Self>;
}

impl<T: Native> Wide<T> for Pair<T> {
    #[inline(always)]
    fn exact(x: T) -> Self {
        Pair::exact(x)
    }
    #[inline(always)]
    fn value(self) -> T {
        Pair::value(self)
    }
    #[inline(always)]
    fn leading(self) -> T {
        self.hi
    }
    #[inline(always)]
    fn sum(a: T, b: T) -> Self {
        Pair::sum(a, b)
    }
    #[inline(always)]
    fn neg(self) -> Self {
        Pair::neg(self)
    }
    #[inline(always)]
    fn times(self, b: Self) -> Self {
        Pair::times(self, b)
    }
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Pair::mul(self, b)
    }
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Pair::add(self, b)
    }
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        Pair::div(self, b)
    }
    #[inline(always)]
    fn sqrt(self) -> T {
        root::sqrt_pair(self)
    }
}

impl<T: Native> Kernel for T {
    type Wide = Pair<T>;

    const CONSTANTS: Constants<Pair<T>> = <T as Native>::CONSTANTS;

    #[inline(always)]
    fn sqrt_scaled(a: T, f: impl Fn(T) -> T) -> T {
        root::sqrt_scaled(a, f)
    }
    #[inline(always)]
    fn cbrt(self) -> T {
        cbrt::cbrt(self)
    }
    #[inline(always)]
    fn cbrt_wide(self) -> Pair<T> {
        cbrt::refine(Kernel::cbrt(self), self)
    }
    #[inline(always)]
    fn is_negligible(self) -> bool {
        self < T::NEGLIGIBLE * T::NEGLIGIBLE
    }
    #[inline(always)]
    fn ln(self) -> T {
        Native::ln(self)
    }
    #[inline(always)]
    fn ln_cos(at: CosSin<Pair<T>>) -> T {
        trig::ln_cos(at)
    }
    #[inline(always)]
    fn atan2(self, x: T) -> T {
        atan::atan2(self, x)
    }
    #[inline(always)]
    fn angle(at: CosSin<T>) -> T {
        atan::of_pair(at)
    }
    #[inline(always)]
    fn from_end(a: T) -> Pair<T> {
        trig::from_end(a)
    }
    #[inline(always)]
    fn at_angle(theta: T) -> CosSin<Pair<T>> {
        trig::at_angle(theta)
    }
    #[inline(always)]
    fn at_angle_fine(theta: T) -> CosSin<Pair<T>> {
        trig::at_angle_fine(theta)
    }
    #[inline(always)]
    fn at_quadrant(quadrant: u32, x: T) -> CosSin<T> {
        turn::at_quadrant(quadrant, x)
    }
    #[inline(always)]
    fn at_turn(u: T) -> CosSin<T> {
        turn::at_turn(u)
    }
    #[inline(always)]
    fn half_turn(p: T) -> CosSin<T> {
        turn::half_turn(p)
    }
    #[inline(always)]
    fn disk_tail_at_angle(a: T) -> T {
        kepler::tail_at_angle(a)
    }
    #[inline(always)]
    fn disk_tail_at_pair(cos: T, sin: T) -> T {
        kepler::tail_at_pair(cos, sin)
    }
    #[inline(always)]
    fn disk_pair_at_tail(p: T) -> CosSin<T> {
        kepler::pair_at_tail(p)
    }
    #[inline(always)]
    fn disk_angle_at_tail(p: T) -> T {
        kepler::angle_at_tail(p)
    }
    #[inline(always)]
    fn ln_wide(x: Pair<T>) -> Pair<T> {
        power::ln(x)
    }
    #[inline(always)]
    fn ln_cos_power(k: Pair<T>, at: CosSin<Pair<T>>) -> Pair<T> {
        power::ln_cos_power(k, at)
    }
    #[inline(always)]
    fn exp_times(a: Pair<T>, c: Pair<T>) -> T {
        power::exp_times(a, c)
    }
    #[inline(always)]
    fn one_minus_exp(a: Pair<T>) -> T {
        power::one_minus_exp(a)
    }
    #[inline(always)]
    fn power_warp(p: Tails<T>, n: Pair<T>) -> CosSin<T> {
        power::warp(p, n)
    }
}
