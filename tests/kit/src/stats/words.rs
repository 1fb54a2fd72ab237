//! Generators made of a closure, and conditioned ones.

use coslobe::rand_core::{Rng, TryRng};
use rand_pcg::Pcg64;
use std::convert::Infallible;

/// Fixed seed, a stream of its own for every subject: equal words would repeat one verdict.
pub fn pcg(subject: &str) -> Pcg64 {
    let stream = subject.bytes().fold(1, |hash: u128, byte| {
        hash.wrapping_mul(0x100_0000_01b3) ^ u128::from(byte)
    });
    Pcg64::new(0x853c_49e6_748f_ea9b, stream)
}

/// Words from a closure; counts the calls of each width.
pub struct Words<F> {
    next: F,
    /// Calls of `next_u32` and `next_u64`.
    pub drawn: (usize, usize),
}

impl<F: FnMut() -> u64> Words<F> {
    pub fn new(next: F) -> Self {
        Words {
            next,
            drawn: (0, 0),
        }
    }
}

impl<F: FnMut() -> u64> TryRng for Words<F> {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.drawn.0 += 1;
        Ok((self.next)() as u32)
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.drawn.1 += 1;
        Ok((self.next)())
    }

    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        unreachable!("no sampler documents bytes")
    }
}

/// The i-th word w becomes `shape(i, w)`.
pub fn shaped(rng: &mut Pcg64, shape: impl Fn(u32, u64) -> u64) -> impl Rng {
    let mut words = 0..;
    Words::new(move || shape(words.next().unwrap_or(u32::MAX), rng.next_u64()))
}

/// Words whose nearer tail is below 2^−`depth`: the side bit stays, zeros follow it.
pub fn deep(depth: u32) -> impl Fn(u32, u64) -> u64 + Copy {
    deep_in(u64::BITS, depth)
}

/// The same for a first word that is drawn as the low `bits` of it.
pub fn deep_in(bits: u32, depth: u32) -> impl Fn(u32, u64) -> u64 + Copy {
    let side = 1u64 << (bits - 1);
    move |i, word| match i {
        0 => (word & side) | ((word & (side - 1)) >> (depth - 1).min(63)),
        1 => word >> depth.saturating_sub(64),
        _ => word,
    }
}

/// The words of a generator.
pub type Source = Box<dyn FnMut() -> u64>;

/// Repeats `words` for ever.
fn cycle(words: &'static [u64]) -> Source {
    let mut words = words.iter().cycle();
    Box::new(move || *words.next().expect("a cycle does not end"))
}

/// Stuck, alternating and counting generators.
pub fn hostile() -> Vec<(&'static str, Source)> {
    const ODD: u64 = 0x5555_5555_5555_5555;
    let mut count = 0u64;
    let mut countdown = 0u64;
    vec![
        ("zeros", cycle(&[0])),
        ("ones", cycle(&[!0])),
        ("top bit", cycle(&[1 << 63])),
        ("all but the top bit", cycle(&[!0 >> 1])),
        ("0, 1", cycle(&[0, 1])),
        ("zeros, ones", cycle(&[0, !0])),
        ("ones, zeros", cycle(&[!0, 0])),
        ("0x55", cycle(&[ODD])),
        ("0xAA", cycle(&[!ODD])),
        ("period 2", cycle(&[ODD, !ODD])),
        ("period 3", cycle(&[0, 1 << 63, !0])),
        (
            "another period 3",
            cycle(&[0x0123_4567_89ab_cdef, 0, 1 << 31]),
        ),
        ("counting", Box::new(move || (count, count += 1).0)),
        (
            "counting down",
            Box::new(move || (countdown = countdown.wrapping_sub(1), countdown).1),
        ),
    ]
}
