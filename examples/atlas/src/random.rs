//! Generators: one for each piece of work, so that threads cannot change a result.

use coslobe::rand_core::{SeedableRng, TryRng};
use rand_pcg::Pcg64;
use std::convert::Infallible;

/// The generator of one piece of work.
pub(crate) fn stream(seed: u64, work: u64) -> Pcg64 {
    // Weyl's sequence keeps the pieces' seeds apart; seed_from_u64 spreads their bits.
    Pcg64::seed_from_u64(seed.wrapping_add(work.wrapping_mul(0x9E37_79B9_7F4A_7C15)))
}

/// Counts the 32-bit words that are drawn through it.
pub(crate) struct Counter {
    rng: Pcg64,
    pub(crate) words: u64,
}

impl Counter {
    pub(crate) fn new(rng: Pcg64) -> Self {
        Counter { rng, words: 0 }
    }
}

impl TryRng for Counter {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.words += 1;
        self.rng.try_next_u32()
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.words += 2;
        self.rng.try_next_u64()
    }

    fn try_fill_bytes(&mut self, dst: &mut [u8]) -> Result<(), Infallible> {
        self.words += dst.len().div_ceil(4) as u64;
        self.rng.try_fill_bytes(dst)
    }
}
