//! The fuzzer's bytes as numbers and as a generator.

use coslobe::CosSin;
use coslobe::rand_core::TryRng;
use kit::{Drawn, Number};
use std::convert::Infallible;

/// Little-endian words of the input, cycling through it; an empty input is all zeros.
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

    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        std::array::from_fn(|_| {
            let byte = self.data.get(self.at).copied().unwrap_or(0);
            self.at = (self.at + 1) % self.data.len().max(1);
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

/// A number in [0, 1], evenly spread.
pub(super) fn unit<T: Number>(word: u64) -> T {
    T::of(word as f64 * 2f64.powi(-64))
}

/// The word read both ways: as bits, and as an even spread over [low, high].
pub(super) fn both<T: Number>(word: u64, low: f64, high: f64) -> [T; 2] {
    let spread = low + (high - low) * unit::<T>(word).wide();
    [T::of_bits(word), T::of(spread)]
}

/// The pair at θ to about an ulp, from the standard library.
pub(super) fn pair_at<T: Number>(theta: f64) -> CosSin<T> {
    CosSin {
        cos: T::of(theta.cos()),
        sin: T::of(theta.sin()),
    }
}
