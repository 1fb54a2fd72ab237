//! Random words by counting: a hash of (pixel, sample, bounce, effect), so that no effect shifts
//! another's.

use crate::{Effect, Meter};
use core::convert::Infallible;
use coslobe::rand_core::{TryRng, utils};

/// Where in the image's estimate a random number belongs.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// The pixel, counted along rows.
    pub pixel: u32,
    /// The sample of that pixel.
    pub sample: u32,
    /// The frame's seed, of which 24 bits count.
    pub seed: u32,
}

/// The four words of a block: PCG4D, folded once more, since its lowest bits repeat along a
/// counter.
///
/// Source: M. Jarzynski and M. Olano, *Hash Functions for GPU Rendering*, JCGT 9(3), 2020.
#[inline(always)]
fn block(v: [u32; 4]) -> [u32; 4] {
    let [x, y, z, w] = v.map(|n| n.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    let mix = |[x, y, z, w]: [u32; 4]| {
        let x = x.wrapping_add(y.wrapping_mul(w));
        let y = y.wrapping_add(z.wrapping_mul(x));
        let z = z.wrapping_add(x.wrapping_mul(y));
        let w = w.wrapping_add(y.wrapping_mul(z));
        [x, y, z, w]
    };
    let fold = |v: [u32; 4]| v.map(|n| n ^ (n >> 16));
    fold(mix(fold(mix([x, y, z, w]))))
}

/// The words of one effect at one bounce of one sample of one pixel: a generator that draws them in
/// order, of 64 bits the high word first.
pub struct Stream<'m, M> {
    counter: [u32; 4],
    words: [u32; 4],
    used: usize,
    /// Words of the block.
    end: usize,
    effect: Effect,
    meter: &'m mut M,
}

impl<'m, M: Meter> Stream<'m, M> {
    /// The stream of `effect` at `bounce`; `part` tells equal effects apart (the lamps).
    #[inline(always)]
    pub fn new(place: Place, bounce: u32, effect: Effect, part: u32, meter: &'m mut M) -> Self {
        let dimension = bounce << 16 | part << 8 | effect as u32;
        let counter = [place.pixel, place.sample, dimension, place.seed << 8];
        Stream {
            counter,
            words: block(counter),
            used: 0,
            end: M::FIRST,
            effect,
            meter,
        }
    }
}

impl<M: Meter> TryRng for Stream<'_, M> {
    type Error = Infallible;
    #[inline(always)]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        if self.used == self.end {
            self.counter[3] = self.counter[3].wrapping_add(1);
            self.words = block(self.counter);
            (self.used, self.end) = (0, 4);
        }
        let word = self.words[self.used & 3];
        self.used += 1;
        self.meter.word(self.effect);
        Ok(word)
    }
    #[inline(always)]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let high = self.try_next_u32()?;
        Ok(u64::from(high) << 32 | u64::from(self.try_next_u32()?))
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        utils::fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}
