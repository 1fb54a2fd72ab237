//! Planted faults of a generator.

use coslobe::rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;
use std::convert::Infallible;

/// A generator made of a closure; a `u64` is two words, the low one first, as PCG has it.
pub(crate) struct Words(pub(crate) Box<dyn FnMut() -> u32>);

impl TryRng for Words {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok((self.0)())
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let low = u64::from((self.0)());
        Ok(low | u64::from((self.0)()) << 32)
    }

    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        unreachable!("no sampler documents bytes")
    }
}

/// A good generator.
pub(crate) fn good(seed: u64) -> Words {
    let mut rng = Pcg32::new(seed, 7);
    Words(Box::new(move || rng.next_u32()))
}

/// Each word of a good generator changed, with another good word at hand.
fn changed(seed: u64, change: impl Fn(u32, &mut Pcg32) -> u32 + 'static) -> Words {
    let (mut rng, mut other) = (Pcg32::new(seed, 7), Pcg32::new(seed, 8));
    Words(Box::new(move || change(rng.next_u32(), &mut other)))
}

fn counted(mut next: impl FnMut(u32) -> u32 + 'static) -> Words {
    let mut count = 0u32;
    Words(Box::new(move || {
        count = count.wrapping_add(1);
        next(count - 1)
    }))
}

pub(crate) fn stuck_bit(seed: u64, bit: u32, high: bool) -> Words {
    let mask = 1 << bit;
    changed(
        seed,
        move |word, _| if high { word | mask } else { word & !mask },
    )
}

/// The bits of `mask` are 1 with probability ½ + `excess`.
pub(crate) fn biased(seed: u64, mask: u32, excess: f64) -> Words {
    let share = (2.0 * excess * f64::from(u32::MAX)) as u32;
    changed(seed, move |word, other| {
        // Each bit on its own: those of `raise` are 1 with probability 2·excess.
        let raise = (0..32).fold(0, |raise, bit| {
            raise | u32::from(other.next_u32() < share) << bit
        });
        word | (raise & mask)
    })
}

/// `words` words of a good generator, over and over.
pub(crate) fn period(seed: u64, words: usize) -> Words {
    let mut rng = Pcg32::new(seed, 7);
    let cycle: Vec<u32> = (0..words).map(|_| rng.next_u32()).collect();
    let mut cycle = cycle.into_iter().cycle();
    Words(Box::new(move || cycle.next().unwrap()))
}

/// Once in `every` words the top bit is that of three words before, which is the same word of the
/// `f32` direction before.
fn correlated(seed: u64, every: u32) -> Words {
    let mut rng = Pcg32::new(seed, 7);
    let mut past = [0u32; 3];
    counted(move |i| {
        let before = &mut past[(i % 3) as usize];
        let word = rng.next_u32();
        let again = rng.next_u32() % every == 0;
        *before = if again {
            (word & !0 >> 1) | (*before & 1 << 31)
        } else {
            word
        };
        *before
    })
}

type Make = fn(u64) -> Words;

/// What a fault is called, how it is made, and the fault that names it in the default test of
/// `Lambert` in `f32`: none where it cannot be seen there.
pub(crate) const FAULTS: &[(&str, Make, Option<&str>)] = &[
    ("stuck at 0", |_| counted(|_| 0), Some("Repeats")),
    ("stuck at all-ones", |_| counted(|_| !0), Some("Repeats")),
    (
        "words 0, !0 in turn",
        |_| counted(|i| (i & 1).wrapping_neg()),
        Some("Repeats"),
    ),
    (
        "words 0x55…, 0xAA… in turn",
        |_| counted(|i| 0x5555_5555 << (i & 1)),
        Some("Repeats"),
    ),
    ("counter", |_| counted(|i| i), Some("Bits")),
    (
        "counter by 2³²/φ",
        |_| counted(|i| i.wrapping_mul(0x9e37_79b9)),
        Some("Bits even"),
    ),
    (
        "lowest bit stuck at 0",
        |seed| stuck_bit(seed, 0, false),
        Some("Bits"),
    ),
    (
        "highest bit stuck at 1",
        |seed| stuck_bit(seed, 31, true),
        Some("Bits"),
    ),
    (
        "16-bit words",
        |seed| changed(seed, |word, _| word >> 16),
        Some("Bits"),
    ),
    (
        "every bit 1 with probability 0.55",
        |seed| biased(seed, !0, 0.05),
        Some("Bits"),
    ),
    (
        "every bit 1 with probability 0.51",
        |seed| biased(seed, !0, 0.01),
        Some("Bits"),
    ),
    (
        "every bit 1 with probability 0.505",
        |seed| biased(seed, !0, 0.005),
        Some("Bits"),
    ),
    (
        "highest bit 1 with probability 0.55",
        |seed| biased(seed, 1 << 31, 0.05),
        Some("Bits"),
    ),
    (
        "lowest bit 1 with probability 0.55",
        |seed| biased(seed, 1, 0.05),
        Some("Bits"),
    ),
    (
        "highest bit 1 with probability 0.51",
        |seed| biased(seed, 1 << 31, 0.01),
        None,
    ),
    (
        "period of 2⁸ words",
        |seed| period(seed, 1 << 8),
        Some("Repeats"),
    ),
    (
        "period of 2¹² words",
        |seed| period(seed, 1 << 12),
        Some("Repeats"),
    ),
    ("period of 2¹⁴ words", |seed| period(seed, 1 << 14), None),
    ("period of 2¹⁶ words", |seed| period(seed, 1 << 16), None),
    (
        "each word twice",
        |seed| {
            let mut rng = Pcg32::new(seed, 7);
            let mut last = 0;
            counted(move |i| {
                if i & 1 == 0 {
                    last = rng.next_u32();
                }
                last
            })
        },
        Some("Flips"),
    ),
    (
        "one word in 20 again",
        |seed| {
            let mut rng = Pcg32::new(seed, 7);
            let mut last = 0;
            counted(move |_| {
                if rng.next_u32() % 20 > 0 {
                    last = rng.next_u32();
                }
                last
            })
        },
        Some("Flips"),
    ),
    (
        "low bits of x ← 1664525 x + 1013904223",
        |seed| {
            let mut x = seed as u32;
            counted(move |_| {
                x = x.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                x
            })
        },
        Some("Flips"),
    ),
    (
        "top bit as 3 words before, 20 % of the time",
        |seed| correlated(seed, 5),
        Some("PolarPairs or AzimuthPairs"),
    ),
    (
        "top bit as 3 words before, 5 % of the time",
        |seed| correlated(seed, 20),
        None,
    ),
];
