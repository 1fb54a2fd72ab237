//! The format of [`Fixed16`](type@super::Fixed16): 16 bits, by products of 16 by 16 bits alone,
//! one instruction each on a Cortex-M0.
//!
//! Arguments and results of kernels are the words of 32 bits that the laws work in.

pub(crate) mod angle;
pub(crate) mod coefficients;
mod draw;
pub(crate) mod kepler;
pub(crate) mod root;
#[cfg(test)]
mod tests;
pub(crate) mod turn;
pub(crate) mod word;

use super::format::{Format, Turn};
use super::planar;
use ::fixed::types::{I0F16, I1F15, U0F16};
use rand_core::Rng;
use word::ONE;

/// Components in Q15, all else in Q16.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Q15;

impl Turn for I0F16 {
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
        q31.clamp(-(ONE as i32), ONE as i32)
    }

    #[inline(always)]
    fn signed(magnitude: u32, sign: u32) -> i32 {
        let mask = (sign as i32) >> 31;
        (magnitude.min(ONE) as i32 ^ mask) - mask
    }

    #[inline(always)]
    fn mul(a: u32, b: u32) -> u32 {
        word::mul(a, b)
    }

    #[inline(always)]
    fn times(x: u32, constant: u32) -> u32 {
        (((x >> 15) + 1) >> 1) * word::rounded(constant)
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

    #[inline(always)]
    fn lobe<const N: usize, R: Rng + ?Sized>(rng: &mut R) -> [I1F15; 3] {
        let (cos, spare) = draw::largest::<N, R>(rng);
        // Half a step, which centres the azimuths of a half-word.
        let phase = if N == 3 {
            spare | (1 << 15)
        } else {
            rng.next_u32()
        };
        draw::spatial(cos, phase)
    }

    #[inline(always)]
    fn largest_of_three<R: Rng + ?Sized>(rng: &mut R) -> (u32, u32) {
        draw::largest::<3, R>(rng)
    }

    /// v = 1 − |sin θ| is a word, and its lowest bit the sign.
    #[inline(always)]
    fn chord<R: Rng + ?Sized>(rng: &mut R) -> [I1F15; 2] {
        let v = rng.next_u32();
        let (sin, sign) = (!v >> 1, v << 31);
        planar::direction::<Q15>(root::complement::<32>(v | 1), sin, sign)
    }
}
