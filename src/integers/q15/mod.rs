//! The format of [`Fixed16`](type@super::Fixed16): 16 bits, by products of 16 by 16 bits alone,
//! one instruction each on a Cortex-M0.
//!
//! Arguments and results of kernels are the words of 32 bits that the laws work in.

pub(crate) mod angle;
pub(crate) mod coefficients;
mod draw;
mod frame;
pub(crate) mod kepler;
pub(crate) mod root;
#[cfg(test)]
mod tests;
pub(crate) mod turn;
pub(crate) mod word;

use super::drawn::Drawn;
use super::format::{Component, Format, Turn};
use super::planar;
use ::fixed::types::{I0F16, I1F15, U0F16};
use rand_core::TryRng;
use word::ONE;

/// Components in Q15, all else in Q16.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Q15;

impl Turn for I0F16 {
    type Format = Q15;
}

impl Component for I1F15 {
    type Format = Q15;
}

impl Format for Q15 {
    const NAME: &str = "Fixed16";

    type Component = I1F15;
    type Probability = U0F16;
    type Turn = I0F16;

    /// Half a unit, which is rounded up.
    const LEAST: u32 = 1 << 15;

    #[inline(always)]
    fn component(q31: i32) -> I1F15 {
        I1F15::from_bits((q31.wrapping_add(1 << 15) >> 16) as i16)
    }

    #[inline(always)]
    fn of_component(component: I1F15) -> i32 {
        i32::from(component.to_bits()) << 16
    }

    #[inline(always)]
    fn probability(q32: u32) -> U0F16 {
        U0F16::from_bits(word::rounded(q32) as u16)
    }

    #[inline(always)]
    fn phase(q32: u32) -> U0F16 {
        U0F16::from_bits((q32.wrapping_add(1 << 15) >> 16) as u16)
    }

    #[inline(always)]
    fn of_probability(probability: U0F16) -> u32 {
        u32::from(probability.to_bits()) << 16
    }

    #[inline(always)]
    fn turn(q32: i32) -> I0F16 {
        I0F16::from_bits((q32.wrapping_add(1 << 15) >> 16) as i16)
    }

    #[inline(always)]
    fn of_turn(turn: I0F16) -> i32 {
        i32::from(turn.to_bits()) << 16
    }

    #[inline(always)]
    fn saturated(magnitude: u32) -> u32 {
        magnitude.min(ONE)
    }

    #[inline(always)]
    fn clamped(q31: i32) -> i32 {
        q31.clamp((ONE as i32).wrapping_neg(), ONE as i32)
    }

    #[inline(always)]
    fn signed(magnitude: u32, sign: u32) -> i32 {
        let mask = (sign as i32) >> 31;
        (magnitude.min(ONE) as i32 ^ mask).wrapping_sub(mask)
    }

    #[inline(always)]
    fn mul(a: u32, b: u32) -> u32 {
        word::mul(a, b)
    }

    #[inline(always)]
    fn times(x: u32, constant: u32) -> u32 {
        (((x >> 15).wrapping_add(1)) >> 1).wrapping_mul(word::rounded(constant))
    }

    #[inline(always)]
    fn sqrt(x: u32) -> u32 {
        root::sqrt(x)
    }

    #[inline(always)]
    fn scaled(x: u32, e: u32) -> u32 {
        root::scaled::<4>(x, e)
    }

    #[inline(always)]
    fn fourth(x: u32) -> (u32, u32) {
        root::fourth(x)
    }

    #[inline(always)]
    fn cbrt(x: u32) -> u32 {
        root::cbrt(x)
    }

    #[inline(always)]
    fn half_recip(d: u32) -> u32 {
        root::half_recip(d)
    }

    #[inline(always)]
    fn complement(v: u32) -> u32 {
        root::complement::<16>(v)
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

    /// 2⁻¹²: of components that are off by 2 units.
    const LENGTH_SLACK: u64 = 1 << 50;
    /// 2⁻¹² of the length: eight units.
    const SLACK: u32 = 1 << 19;

    #[inline(always)]
    fn units(component: I1F15) -> i32 {
        i32::from(component.to_bits()).max(-0x7FFF)
    }

    #[inline(always)]
    fn of_units(units: i32) -> I1F15 {
        I1F15::from_bits(units as i16)
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
    fn part(sin: i32, part: i32) -> I1F15 {
        let [a, b] = [sin, part].map(|c| Self::clamped(c).wrapping_add(1 << 15) >> 16);
        I1F15::from_bits((a.wrapping_mul(b).wrapping_add(1 << 14) >> 15) as i16)
    }

    #[inline(always)]
    fn lobe<const N: usize, R: TryRng + ?Sized>(
        rng: &mut R,
    ) -> Result<Drawn<[I1F15; 3]>, R::Error> {
        let (cos, spare) = draw::largest::<N, R>(rng)?;
        // Half a step, which centres the azimuths of a half-word.
        let phase = if N == 3 {
            spare | (1 << 15)
        } else {
            rng.try_next_u32()?
        };
        Ok(draw::spatial(cos, phase))
    }

    #[inline(always)]
    fn largest<const N: usize, R: TryRng + ?Sized>(rng: &mut R) -> Result<u32, R::Error> {
        Ok(draw::largest::<N, R>(rng)?.0)
    }

    #[inline(always)]
    fn largest_of_three<R: TryRng + ?Sized>(rng: &mut R) -> Result<(u32, u32), R::Error> {
        draw::largest::<3, R>(rng)
    }

    /// A word's top bit is the sign, the others are v = 1 − |sin θ|.
    #[inline(always)]
    fn chord<R: TryRng + ?Sized>(rng: &mut R) -> Result<Drawn<[I1F15; 2]>, R::Error> {
        let word = rng.try_next_u32()?;
        let v = (word << 1) | 1;
        Ok(planar::direction::<Q15>(
            root::complement::<32>(v),
            !v >> 1,
            word,
        ))
    }
}
