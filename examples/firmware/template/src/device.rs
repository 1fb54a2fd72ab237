//! In place of a device's random number generator: read its registers here.

use core::fmt;
use coslobe::rand_core::TryRng;

/// The generator has no word yet.
#[derive(Debug)]
pub(crate) struct NotReady;

impl fmt::Display for NotReady {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the generator is not ready")
    }
}

impl core::error::Error for NotReady {}

/// Counts up in odd steps and mixes: for the example alone. Not ready when it is first asked.
pub(crate) struct Device {
    state: u32,
    ready: bool,
}

impl Device {
    pub(crate) fn new() -> Self {
        Device {
            state: 2024,
            ready: false,
        }
    }

    /// What a device may do at any time.
    pub(crate) fn fail_once(&mut self) {
        self.ready = false;
    }

    pub(crate) fn word(&mut self) -> Result<u32, NotReady> {
        if !core::mem::replace(&mut self.ready, true) {
            return Err(NotReady);
        }
        self.state = self.state.wrapping_add(0x9e37_79b9);
        let x = (self.state ^ self.state >> 16).wrapping_mul(0x85eb_ca6b);
        let x = (x ^ x >> 13).wrapping_mul(0xc2b2_ae35);
        Ok(x ^ x >> 16)
    }
}

impl TryRng for Device {
    type Error = NotReady;

    fn try_next_u32(&mut self) -> Result<u32, NotReady> {
        self.word()
    }

    fn try_next_u64(&mut self) -> Result<u64, NotReady> {
        let low = u64::from(self.word()?);
        Ok(u64::from(self.word()?) << 32 | low)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), NotReady> {
        for chunk in bytes.chunks_mut(4) {
            let word = self.word()?.to_le_bytes();
            chunk.iter_mut().zip(word).for_each(|(to, from)| *to = from);
        }
        Ok(())
    }
}
