//! The formulas' kernels in a hardware format.

use super::exp2::Scale;
use super::float::Float;
use super::format::Native;
use super::pair::Pair;
use super::power::Cosine;
use super::tail_root::TailRoot;
use super::{atan, cbrt, kepler, power, root, trig, turn};
use crate::arithmetic::constants::Constants;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::{CosSin, Tails};

impl<T: Native> Wide<T> for Pair<T> {
    #[inline(always)]
    fn from_value(x: T) -> Self {
        Pair::from_value(x)
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
    fn two_sum(a: T, b: T) -> Self {
        Pair::two_sum(a, b)
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
    type Cosine = Cosine<T>;
    type Scale = Scale<T>;
    type TailRoot = TailRoot<T>;

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
    fn cbrt_wide(p: Tails<T>) -> Option<Pair<T>> {
        // Below this the other tail is 1 to all digits.
        let least = T::NEGLIGIBLE * T::NEGLIGIBLE;
        if p.lower() < least || p.upper() < least {
            None
        } else {
            Some(cbrt::refine(Kernel::cbrt(p.upper()), p.upper()))
        }
    }
    #[inline(always)]
    fn ln(self) -> T {
        Float::ln(self)
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
        atan::of_direction(at)
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
    fn disk_tail_at_direction(cos: T, sin: T) -> T {
        kepler::tail_at_direction(cos, sin)
    }
    #[inline(always)]
    fn disk_direction_at_tail(p: T) -> CosSin<T> {
        kepler::direction_at_tail(p)
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
    fn cosine(at: CosSin<T>) -> Cosine<T> {
        power::cosine(at)
    }
    #[inline(always)]
    fn cosine_at_angle(theta: T) -> (Cosine<T>, T) {
        power::cosine_at_angle(theta)
    }
    #[inline(always)]
    fn scale(x: Pair<T>) -> Scale<T> {
        Scale::new(x)
    }
    #[inline(always)]
    fn two_over(x: Pair<T>) -> Scale<T> {
        Scale::two_over(x)
    }
    #[inline(always)]
    fn power_times(k: Pair<T>, at: Cosine<T>, scale: Scale<T>, factor: T) -> T {
        power::power_times(k, at, scale, factor)
    }
    #[inline(always)]
    fn ln_power_times_sine(k: Pair<T>, at: Cosine<T>, c: Pair<T>) -> T {
        power::ln_power_times_sine(k, at, c)
    }
    #[inline(always)]
    fn power_tails(n: Pair<T>, at: Cosine<T>) -> (T, T) {
        power::power_tails(n, at)
    }
    #[inline(always)]
    fn tail_root(n: Pair<T>) -> TailRoot<T> {
        TailRoot::new(n)
    }
    #[inline(always)]
    fn power_warp(p: Tails<T>, root: TailRoot<T>) -> CosSin<T> {
        root.at(p)
    }
}
