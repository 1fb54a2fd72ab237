//! The fuzzer's bytes: what is checked, its numbers, and a generator.

use coslobe::CosSin;
use coslobe::rand_core::TryRng;
use kit::{Drawn, Id, Number};
use std::convert::Infallible;

/// Four bytes that choose, then little-endian words of 64 bits.
#[derive(Clone)]
pub(super) struct Input<'a> {
    choices: [u8; 4],
    /// The first is that of an exponent, whether or not the law has one.
    pub words: Words<'a>,
}

impl<'a> Input<'a> {
    pub(super) fn new(data: &'a [u8]) -> Self {
        let (choices, words) = data.split_at(data.len().min(4));
        let choices = std::array::from_fn(|i| choices.get(i).copied().unwrap_or(0));
        let words = Words::new(words);
        Input { choices, words }
    }

    fn choice(&self, i: usize, of: usize) -> usize {
        usize::from(self.choices[i]) % of
    }

    /// Which of so many operations.
    pub(super) fn operation(&self, of: usize) -> usize {
        self.choice(0, of)
    }

    /// Which of so many number types.
    pub(super) fn number_type(&self, of: usize) -> usize {
        self.choice(1, of)
    }

    /// Which of so many laws.
    pub(super) fn which_law(&self, of: usize) -> usize {
        self.choice(2, of)
    }

    /// The law; of `CosPower` with the first word's exponent, which it may refuse.
    pub(super) fn law<T: Number>(&mut self) -> Id {
        let k: T = self.number(0.0, 64.0);
        match Id::ALL[self.which_law(Id::ALL.len())] {
            Id::CosPower(_) => Id::CosPower(k.wide()),
            law => law,
        }
    }

    /// The next word, as the last choice has it: as bits, or evenly spread over [low, high].
    pub(super) fn number<T: Number>(&mut self, low: f64, high: f64) -> T {
        let word = self.words.word();
        if self.flag() {
            T::of(low + (high - low) * (word as f64 * 2f64.powi(-64)))
        } else {
            T::of_bits(word)
        }
    }

    /// A bit of the last choice, round and round.
    pub(super) fn flag(&mut self) -> bool {
        self.choices[3] = self.choices[3].rotate_right(1);
        self.choices[3] >> 7 == 1
    }

    /// Any two numbers, or a direction by an angle or by one component.
    pub(super) fn pair<T: Number>(&mut self) -> CosSin<T> {
        if self.flag() {
            self.direction()
        } else {
            let (cos, sin) = (self.number(-1.0, 1.0), self.number(-1.0, 1.0));
            CosSin { cos, sin }
        }
    }

    /// A direction of unit length to an ulp, cos θ ≥ 0, from its smaller component or its angle.
    pub(super) fn direction<T: Number>(&mut self) -> CosSin<T> {
        let (by_angle, by_cos) = (self.flag(), self.flag());
        let x = self.number::<T>(-1.0, 1.0).wide();
        if by_angle {
            let angle = (x * std::f64::consts::FRAC_PI_2).clamp(-1.6, 1.6);
            return CosSin {
                cos: T::of(angle.cos().abs()),
                sin: T::of(angle.sin()),
            };
        }
        let small = T::of(if x.abs() <= 0.7 { x } else { 0.7 });
        let other = T::of((1.0 - small.wide() * small.wide()).sqrt());
        if by_cos {
            let cos = if small.negative() { -small } else { small };
            let sin = if small.negative() { -other } else { other };
            CosSin { cos, sin }
        } else {
            CosSin {
                cos: other,
                sin: small,
            }
        }
    }
}

/// Words of the input, cycling through it; an empty input is all zeros.
///
/// As a generator it is as bad as the fuzzer likes: stuck, periodic, or chosen word by word.
#[derive(Clone)]
pub(super) struct Words<'a> {
    data: &'a [u8],
    at: usize,
    /// Calls of `next_u32` and of `next_u64`.
    pub drawn: Drawn,
}

impl<'a> Words<'a> {
    pub(super) fn new(data: &'a [u8]) -> Self {
        Words {
            data,
            at: 0,
            drawn: (0, 0),
        }
    }

    /// The same with nothing counted yet.
    pub(super) fn uncounted(&self) -> Self {
        Words {
            drawn: (0, 0),
            ..*self
        }
    }

    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        std::array::from_fn(|_| {
            let byte = self.data.get(self.at).copied().unwrap_or(0);
            self.at += 1;
            if self.at >= self.data.len() {
                self.at = 0;
            }
            byte
        })
    }

    /// The next word, not counted as drawn.
    pub(super) fn word(&mut self) -> u64 {
        u64::from_le_bytes(self.bytes())
    }
}

impl TryRng for Words<'_> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.drawn.0 += 1;
        Ok(u32::from_le_bytes(self.bytes()))
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.drawn.1 += 1;
        Ok(self.word())
    }

    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        panic!("no sampler is documented to call fill_bytes");
    }
}
