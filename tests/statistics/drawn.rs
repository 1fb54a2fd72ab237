//! The words that the samplers in integers are documented to draw, and how to reach their tails.

use kit::Id;
use kit::integer::{Format, Long, Short};

/// Of all samples.
pub(crate) const N: usize = 1_000_000;

/// Shapes the i-th word so that its law's deep tail is met.
pub(crate) type Shape = fn(u32, u64) -> u64;

/// What a law is documented to draw.
pub(crate) struct Drawn {
    pub(crate) words: usize,
    /// Of all samples; more would show the grid of the horizon's last unit.
    pub(crate) samples: usize,
    /// The shaped words give tails below 2^−`depth`.
    pub(crate) depth: u32,
    pub(crate) shape: Shape,
}

pub(crate) trait Draws: Format {
    const TAIL_SAMPLES: usize;
    fn of(id: Id) -> Drawn;
}

/// Below 2¹⁷.
fn low(word: u64) -> u64 {
    u64::from(word as u32 >> 15)
}

impl Draws for Long {
    const TAIL_SAMPLES: usize = 50_000;
    /// Of a maximum of n words below 2^(32−s) the probability is 2^−ns; of two words as one number,
    /// 2^−s.
    fn of(id: Id) -> Drawn {
        let (words, depth, shape): (_, _, Shape) = match (id.planar(), id.exponent() as u32) {
            (false, 1) => (3, 30, |i, word| if i < 2 { low(word) } else { word }),
            (false, 2) => (4, 45, |i, word| if i < 3 { low(word) } else { word }),
            (false, _) => (5, 60, |i, word| if i < 4 { low(word) } else { word }),
            // The top bit is the sign.
            (true, 2) => (3, 46, |i, word| match i {
                0 => (word & 0x8000_0000) | ((word & 0x7FFF_FFFF) >> 15),
                _ => low(word),
            }),
            (true, 1) => (
                2,
                31,
                |i, word| if i == 0 { word & 0x8000_0001 } else { word },
            ),
            (true, _) => (1, 17, |_, word| word | 0x7FFF_8000),
        };
        Drawn {
            words,
            samples: N,
            depth,
            shape,
        }
    }
}

/// Both half-words below 2¹².
fn halves(word: u64) -> u64 {
    word & 0x0FFF_0FFF
}

impl Draws for Short {
    const TAIL_SAMPLES: usize = 20_000;
    fn of(id: Id) -> Drawn {
        // The second word's upper half is the azimuth or the sign.
        const THREE: Shape = |i, word| match i {
            0 => halves(word),
            1 => word & 0xFFFF_0FFF,
            _ => word,
        };
        let (words, depth, shape): (_, _, Shape) = match (id.planar(), id.exponent() as u32) {
            (false, 1) => (2, 8, |i, word| if i == 0 { halves(word) } else { word }),
            (false, 2) => (2, 12, THREE),
            (false, _) => (3, 16, |i, word| if i < 2 { halves(word) } else { word }),
            (true, 2) => (2, 13, THREE),
            (true, 1) => (1, 11, |_, word| {
                (word & 0x8000_0000) | ((word & 0x7FFF_FFFF) >> 10)
            }),
            (true, _) => (1, 7, |_, word| word | 0x7E00_0000),
        };
        let samples = if id.exponent() == 0.0 { N / 10 } else { N };
        Drawn {
            words,
            samples,
            depth,
            shape,
        }
    }
}
