//! The generator's words on their way to a sampler, their bits counted.

use super::cells::{Chi2, Sum};
use core::convert::Infallible;
use rand_core::{Rng, TryRng};

/// Enough planes that 65 535 samples of 16 words do not overflow them.
const PLANES: usize = 20;
const MOST: u32 = (1 << PLANES) - 1;

/// 32 counters, one for each bit of a word, as bit planes: adding a word is a carry that ripples
/// through two planes on average, not 32 sums.
#[derive(Clone, Debug, Default)]
struct Columns {
    planes: [u32; PLANES],
}

impl Columns {
    fn add(&mut self, word: u32) {
        let mut carry = word;
        for plane in &mut self.planes {
            if carry == 0 {
                return;
            }
            (*plane, carry) = (*plane ^ carry, *plane & carry);
        }
    }

    fn count(&self, bit: u32) -> u32 {
        let planes = self.planes.iter().rev();
        planes.fold(0, |count, plane| (count << 1) | ((plane >> bit) & 1))
    }

    /// χ² of all 32 bits against ½, each out of `n`.
    fn chi2(&self, n: u32) -> Option<Chi2> {
        let mut sum = Sum::default();
        for bit in 0..32 {
            let off = (u64::from(self.count(bit)) << 1).abs_diff(u64::from(n));
            sum.add(bit as u8, off.wrapping_mul(off), 0);
        }
        sum.over(u64::from(n), 32)
    }
}

/// What was seen of a generator's 32-bit words.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    words: u32,
    last: u32,
    ones: Columns,
    flips: Columns,
}

impl Tally {
    fn add(&mut self, word: u32) {
        if self.words == MOST {
            return;
        }
        self.ones.add(word);
        if self.words > 0 {
            self.flips.add(word ^ self.last);
        }
        self.last = word;
        self.words = self.words.wrapping_add(1);
    }

    pub(super) fn words(&self) -> u32 {
        self.words
    }

    /// Ones of each bit.
    pub(super) fn bits(&self) -> Option<Chi2> {
        self.ones.chi2(self.words)
    }

    /// Changes of each bit from one word to the next.
    pub(super) fn flips(&self) -> Option<Chi2> {
        self.flips.chi2(self.words.saturating_sub(1))
    }
}

/// A generator that hands on the words of another and counts their bits. Bytes pass uncounted.
pub(super) struct Tap<'a, R: ?Sized> {
    rng: &'a mut R,
    tally: &'a mut Tally,
}

impl<'a, R: ?Sized> Tap<'a, R> {
    pub(super) fn new(rng: &'a mut R, tally: &'a mut Tally) -> Self {
        Tap { rng, tally }
    }
}

impl<R: Rng + ?Sized> TryRng for Tap<'_, R> {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let word = self.rng.next_u32();
        self.tally.add(word);
        Ok(word)
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let word = self.rng.next_u64();
        self.tally.add(word as u32);
        self.tally.add((word >> 32) as u32);
        Ok(word)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.rng.fill_bytes(bytes);
        Ok(())
    }
}
