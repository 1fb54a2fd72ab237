//! The format of [`Fixed`](type@super::Fixed): 32 bits, by long products.

pub(crate) mod angle;
pub(crate) mod cbrt;
pub(crate) mod coefficients;
pub(crate) mod draw;
mod frame;
pub(crate) mod kepler;
pub(crate) mod log;
pub(crate) mod recip;
pub(crate) mod sqrt;
#[cfg(test)]
mod tests;
pub(crate) mod turn;

use super::drawn::Drawn;
use super::format::{Component, Format, Turn};
use super::kernel::{mul, signed};
use super::planar;
use ::fixed::types::{I0F32, I1F31, U0F32};
use rand_core::TryRng;
use turn::ONE;

/// Components in Q31, all else in Q32.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Q31;

impl Turn for I0F32 {
    type Format = Q31;
}

impl Component for I1F31 {
    type Format = Q31;
}

impl Format for Q31 {
    const NAME: &str = "Fixed";

    type Component = I1F31;
    type Probability = U0F32;
    type Turn = I0F32;

    const LEAST: u32 = 1;

    #[inline(always)]
    fn component(q31: i32) -> I1F31 {
        I1F31::from_bits(q31)
    }

    #[inline(always)]
    fn of_component(component: I1F31) -> i32 {
        component.to_bits()
    }

    #[inline(always)]
    fn probability(q32: u32) -> U0F32 {
        U0F32::from_bits(q32)
    }

    #[inline(always)]
    fn phase(q32: u32) -> U0F32 {
        U0F32::from_bits(q32)
    }

    #[inline(always)]
    fn of_probability(probability: U0F32) -> u32 {
        probability.to_bits()
    }

    #[inline(always)]
    fn turn(q32: i32) -> I0F32 {
        I0F32::from_bits(q32)
    }

    #[inline(always)]
    fn of_turn(turn: I0F32) -> i32 {
        turn.to_bits()
    }

    #[inline(always)]
    fn saturated(magnitude: u32) -> u32 {
        magnitude.min(ONE)
    }

    #[inline(always)]
    fn clamped(q31: i32) -> i32 {
        q31
    }

    #[inline(always)]
    fn signed(magnitude: u32, sign: u32) -> i32 {
        signed(magnitude, sign)
    }

    #[inline(always)]
    fn mul(a: u32, b: u32) -> u32 {
        mul::mul_high(a, b)
    }

    #[inline(always)]
    fn times(x: u32, constant: u32) -> u32 {
        mul::mul_high(x, constant)
    }

    #[inline(always)]
    fn sqrt(x: u32) -> u32 {
        sqrt::sqrt(x)
    }

    #[inline(always)]
    fn scaled(x: u32, e: u32) -> u32 {
        sqrt::scaled(x, e)
    }

    #[inline(always)]
    fn fourth(x: u32) -> (u32, u32) {
        sqrt::fourth(x)
    }

    #[inline(always)]
    fn cbrt(x: u32) -> u32 {
        cbrt::cbrt(x)
    }

    #[inline(always)]
    fn half_recip(d: u32) -> u32 {
        recip::half_recip(d)
    }

    #[inline(always)]
    fn complement(v: u32) -> u32 {
        sqrt::complement(u64::from(v) << 32)
    }

    #[inline(always)]
    fn from_end(z: u32) -> u32 {
        kepler::from_end(z)
    }

    #[inline(always)]
    fn quarter(x: u32) -> (u32, u32) {
        turn::quarter(x)
    }

    #[inline(always)]
    fn cos_sin(turn: u32) -> (i32, i32) {
        turn::cos_sin(turn)
    }

    #[inline(always)]
    fn first_quadrant(cos: u32, sin: u32) -> u32 {
        angle::first_quadrant(cos, sin)
    }

    /// 2⁻²⁶: of components that are off by 4 units.
    const LENGTH_SLACK: u64 = 1 << 36;
    /// 2⁻²⁰ of the length.
    const SLACK: u32 = 1 << 11;

    #[inline(always)]
    fn units(component: I1F31) -> i32 {
        component.to_bits().max(i32::MAX.wrapping_neg())
    }

    #[inline(always)]
    fn of_units(units: i32) -> I1F31 {
        I1F31::from_bits(units)
    }

    #[inline(always)]
    fn square_off(normal: [i32; 3]) -> u32 {
        frame::square_off(normal)
    }

    #[inline(always)]
    fn frame_recip(z: i32) -> i32 {
        frame::recip(z)
    }

    #[inline(always)]
    fn to_world(normal: [i32; 3], recip: i32, local: [i32; 3]) -> [i32; 3] {
        frame::to_world(normal, recip, local)
    }

    #[inline(always)]
    fn to_local(normal: [i32; 3], recip: i32, world: [i32; 3]) -> [i32; 3] {
        frame::to_local(normal, recip, world)
    }

    #[inline(always)]
    fn part(sin: i32, part: i32) -> I1F31 {
        let size = mul::mul_high((sin as u32) << 1, part.unsigned_abs());
        I1F31::from_bits(signed(size, part as u32))
    }

    #[inline(always)]
    fn lobe<const N: usize, R: TryRng + ?Sized>(
        rng: &mut R,
    ) -> Result<Drawn<[I1F31; 3]>, R::Error> {
        let x = draw::largest::<N, R>(rng)?;
        draw::spatial(x.0 >> 1, sqrt::complement(draw::less(x)), rng)
    }

    #[inline(always)]
    fn largest<const N: usize, R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        Ok(draw::largest::<N, R>(rng)?.0)
    }

    /// The sign is the top bit of the first, of which 31 bits are left.
    #[inline(always)]
    fn largest_of_three<R: TryRng + ?Sized>(rng: &mut R) -> Result<(u32, u32), R::Error> {
        let first = rng.try_next_u32()?;
        let two = ((first << 1) | 1).max(rng.try_next_u32()?);
        Ok((two.max(rng.try_next_u32()?), first))
    }

    /// The top bit of two words is the sign, the others are v = 1 − |sin θ|.
    #[inline(always)]
    fn chord<R: TryRng + ?Sized>(rng: &mut R) -> Result<Drawn<[I1F31; 2]>, R::Error> {
        let words = draw::long(rng)?;
        let v = (words << 1) | 1;
        let (sin, sign) = (!((v >> 32) as u32) >> 1, (words >> 32) as u32);
        Ok(planar::direction::<Q31>(sqrt::complement(v), sin, sign))
    }
}
