//! The fuzzer's bytes as numbers and as a generator.

use coslobe::rand_core::TryRng;
use std::convert::Infallible;

/// Little-endian words of the input, cycling through it; an empty input is all zeros.
///
/// As a generator it is as bad as the fuzzer likes: stuck, periodic, or chosen word by word.
#[derive(Clone)]
pub(super) struct Words<'a> {
    data: &'a [u8],
    at: usize,
    /// Calls of `next_u32` and of `next_u64`.
    pub drawn: [u32; 2],
}

impl<'a> Words<'a> {
    pub(super) fn new(data: &'a [u8]) -> Self {
        Words {
            data,
            at: 0,
            drawn: [0; 2],
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
        self.drawn[0] += 1;
        Ok(u32::from_le_bytes(self.bytes()))
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.drawn[1] += 1;
        Ok(self.word())
    }

    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        panic!("no sampler is documented to call fill_bytes");
    }
}
