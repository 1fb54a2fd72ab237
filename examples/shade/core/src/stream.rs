//! Random words by counting: a hash of (pixel, sample, bounce, effect), so that no effect shifts another's.

use crate::{Effect, Meter};

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

/// The four words of a block: PCG4D, folded once more, since its lowest bits repeat along a counter.
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

/// The words of one effect at one bounce of one sample of one pixel.
pub struct Stream<'m, M> {
    counter: [u32; 4],
    words: [u32; 4],
    used: usize,
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
            effect,
            meter,
        }
    }
}

/// Where random words come from. `rand_core`'s traits say the same, but what is provided there is not
/// always inlined, and then a stream's state goes through memory.
pub trait Words {
    /// The next 32 bits.
    fn word(&mut self) -> u32;
    /// A number is drawn from here.
    #[inline(always)]
    fn begin(&mut self) {}
    /// The next 64 bits, high word first.
    #[inline(always)]
    fn long(&mut self) -> u64 {
        let high = self.word();
        u64::from(high) << 32 | u64::from(self.word())
    }
}

impl<M: Meter> Words for Stream<'_, M> {
    #[inline(always)]
    fn begin(&mut self) {
        // No number takes more than a block.
        if M::ALIGNED && self.used > 0 {
            self.used = 4;
        }
    }
    #[inline(always)]
    fn word(&mut self) -> u32 {
        if self.used == 4 {
            self.counter[3] = self.counter[3].wrapping_add(1);
            self.words = block(self.counter);
            self.used = 0;
        }
        let word = self.words[self.used & 3];
        self.used += 1;
        self.meter.word(self.effect);
        word
    }
}
