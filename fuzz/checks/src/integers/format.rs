//! The operations of a law in either format, an operation a line: their names are the same, but no
//! trait is public.

use crate::input::Words;
use coslobe::integers::{Fixed16Law, FixedLaw, cos_sin};
use coslobe::{CosSin, Fixed, Fixed16};
use fixed::traits::Fixed as Number;
use fixed::types::{I0F16, I0F32, I1F15, I1F31, U0F16, U0F32, U16F16};

/// A law in one format. An argument that is one word is read from the top of 32 bits.
pub(super) trait Law: Copy {
    /// Whether it is the format of 16 bits.
    const SHORT: bool;
    /// Units of 1.
    const COMPONENT: f64;
    const PROBABILITY: f64;
    /// How many units a length may be off.
    const LENGTH: f64;
    type Component: Number;
    type Probability: Number;
    type Turn: Number;
    type Direction: AsRef<[Self::Component]>;

    fn component(word: u64) -> Self::Component;
    fn probability(word: u32) -> Self::Probability;
    fn turn(word: u32) -> Self::Turn;
    fn cos_sin(turn: u32) -> CosSin<Self::Component>;

    fn warp(&self, u: u32) -> CosSin<Self::Component>;
    fn warp_sf(&self, q: u32) -> CosSin<Self::Component>;
    fn unwarps(&self, at: CosSin<Self::Component>) -> [f64; 2];
    fn density(&self, at: CosSin<Self::Component>) -> f64;
    fn lambert_weight(&self, at: CosSin<Self::Component>) -> U16F16;
    fn pdf(&self, turn: u32) -> f64;
    fn tails(&self, turn: u32) -> [f64; 2];
    fn quantile(&self, p: u32) -> Self::Turn;
    fn isf(&self, q: u32) -> Self::Turn;
    fn sample(&self, words: &mut Words) -> Self::Direction;
    fn try_sample(&self, words: &mut Words) -> Self::Direction;
}

pub(super) fn wide(x: impl Number) -> f64 {
    x.to_num()
}

fn got<T>(result: Result<T, std::convert::Infallible>) -> T {
    let Ok(value) = result;
    value
}

impl<L: FixedLaw<Direction: AsRef<[I1F31]>>> Law for Fixed<L> {
    const SHORT: bool = false;
    const COMPONENT: f64 = 2147483648.0;
    const PROBABILITY: f64 = 4294967296.0;
    const LENGTH: f64 = 4.0;
    type Component = I1F31;
    type Probability = U0F32;
    type Turn = I0F32;
    type Direction = L::Direction;

    fn component(word: u64) -> I1F31 {
        I1F31::from_bits((word >> 32) as i32)
    }
    fn probability(word: u32) -> U0F32 {
        U0F32::from_bits(word)
    }
    fn turn(word: u32) -> I0F32 {
        I0F32::from_bits(word as i32)
    }
    fn cos_sin(turn: u32) -> CosSin<I1F31> {
        cos_sin(Self::turn(turn))
    }
    fn warp(&self, u: u32) -> CosSin<I1F31> {
        self.warp(Self::probability(u))
    }
    fn warp_sf(&self, q: u32) -> CosSin<I1F31> {
        self.warp_sf(Self::probability(q))
    }
    fn unwarps(&self, at: CosSin<I1F31>) -> [f64; 2] {
        [self.unwarp(at), self.unwarp_sf(at)].map(wide)
    }
    fn density(&self, at: CosSin<I1F31>) -> f64 {
        wide(self.density(at))
    }
    fn lambert_weight(&self, at: CosSin<I1F31>) -> U16F16 {
        self.lambert_weight(at)
    }
    fn pdf(&self, turn: u32) -> f64 {
        wide(self.pdf(Self::turn(turn)))
    }
    fn tails(&self, turn: u32) -> [f64; 2] {
        let theta = Self::turn(turn);
        [self.cdf(theta), self.sf(theta)].map(wide)
    }
    fn quantile(&self, p: u32) -> I0F32 {
        self.quantile(Self::probability(p))
    }
    fn isf(&self, q: u32) -> I0F32 {
        self.isf(Self::probability(q))
    }
    fn sample(&self, words: &mut Words) -> L::Direction {
        self.sample(words)
    }
    fn try_sample(&self, words: &mut Words) -> L::Direction {
        got(self.try_sample(words))
    }
}

impl<L: Fixed16Law<Direction: AsRef<[I1F15]>>> Law for Fixed16<L> {
    const SHORT: bool = true;
    const COMPONENT: f64 = 32768.0;
    const PROBABILITY: f64 = 65536.0;
    const LENGTH: f64 = 2.0;
    type Component = I1F15;
    type Probability = U0F16;
    type Turn = I0F16;
    type Direction = L::Direction;

    fn component(word: u64) -> I1F15 {
        I1F15::from_bits((word >> 48) as i16)
    }
    fn probability(word: u32) -> U0F16 {
        U0F16::from_bits((word >> 16) as u16)
    }
    fn turn(word: u32) -> I0F16 {
        I0F16::from_bits((word >> 16) as i16)
    }
    fn cos_sin(turn: u32) -> CosSin<I1F15> {
        cos_sin(Self::turn(turn))
    }
    fn warp(&self, u: u32) -> CosSin<I1F15> {
        self.warp(Self::probability(u))
    }
    fn warp_sf(&self, q: u32) -> CosSin<I1F15> {
        self.warp_sf(Self::probability(q))
    }
    fn unwarps(&self, at: CosSin<I1F15>) -> [f64; 2] {
        [self.unwarp(at), self.unwarp_sf(at)].map(wide)
    }
    fn density(&self, at: CosSin<I1F15>) -> f64 {
        wide(self.density(at))
    }
    fn lambert_weight(&self, at: CosSin<I1F15>) -> U16F16 {
        self.lambert_weight(at)
    }
    fn pdf(&self, turn: u32) -> f64 {
        wide(self.pdf(Self::turn(turn)))
    }
    fn tails(&self, turn: u32) -> [f64; 2] {
        let theta = Self::turn(turn);
        [self.cdf(theta), self.sf(theta)].map(wide)
    }
    fn quantile(&self, p: u32) -> I0F16 {
        self.quantile(Self::probability(p))
    }
    fn isf(&self, q: u32) -> I0F16 {
        self.isf(Self::probability(q))
    }
    fn sample(&self, words: &mut Words) -> L::Direction {
        self.sample(words)
    }
    fn try_sample(&self, words: &mut Words) -> L::Direction {
        got(self.try_sample(words))
    }
}
