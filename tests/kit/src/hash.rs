//! The hash of a stream of results.

use crate::Sink;

/// FNV-1a over 64-bit words instead of bytes, with a rotation that carries the top bits down, where
/// the product alone would leave two changed signs to cancel. Each step is a bijection of the
/// state, so no single changed value goes unseen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Hash(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Takes the next word in.
    #[inline]
    pub fn add(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(23) ^ word).wrapping_mul(0x100_0000_01b3);
    }

    /// The hash of all words so far.
    pub fn value(self) -> u64 {
        self.0
    }
}

impl Sink for Hash {
    const NAMES_INPUTS: bool = false;

    #[inline]
    fn take(&mut self, _: &'static str, bits: u64) {
        self.add(bits);
    }
}
