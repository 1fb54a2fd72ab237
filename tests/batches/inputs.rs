//! Inputs that are hard: ends, neighbours of every branch, subnormal numbers, infinities and NaN,
//! and noise.

use coslobe::uniform::{TailBits, TurnBits};
use kit::Number;
use kit::batch::BatchNumber;

/// Lengths, and how many numbers results lie behind the start of their memory: long batches end
/// their first block where a line of the cache begins.
pub(crate) fn lengths_and_places() -> impl Iterator<Item = (usize, usize)> {
    let long = [0, 1, 6, 15].map(|place| (1100, place));
    LENGTHS.map(|len| (len, 0)).chain([(1000, 0)]).chain(long)
}

/// Shorter and longer than a block, and none.
pub(crate) const LENGTHS: std::ops::RangeInclusive<usize> = 0..=67;

/// A word of noise.
pub(crate) fn noise(n: u64) -> u64 {
    let mut x = n.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    x = (x ^ x >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    x ^ x >> 27
}

fn hard<T: Number>() -> Vec<T> {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let width = 8 * size_of::<T>() as u32;
    let mut list = vec![
        T::of(f64::NAN),
        -T::of(f64::NAN),
        T::of_bits((1 << (width - 1)) - 1), // NaN with a payload
        T::of(f64::INFINITY),
        -T::of(f64::INFINITY),
        T::of(0.0),
        -T::of(0.0),
        T::MAX,
    ];
    let places = [
        0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, FRAC_PI_4, FRAC_PI_2, PI, 2.0, 1e-5,
        1e-9, 1e-20, 1e-37, 1e-40,
    ];
    for place in places {
        let bits = T::of(place).bits();
        for bits in [bits - 1, bits, bits + 1] {
            list.extend([T::of_bits(bits), -T::of_bits(bits)]);
        }
    }
    let least_normal = T::MIN_NORMAL.bits();
    list.extend([1, 2, 3, least_normal - 1, least_normal, least_normal + 1].map(T::of_bits));
    list
}

/// Numbers for one argument.
pub(crate) fn numbers<T: Number>() -> Vec<T> {
    let mut list = hard::<T>();
    let digits = 8 * size_of::<T>() as u32;
    for i in 0..900 {
        let word = noise(i);
        list.push(match i % 3 {
            0 => T::of((word >> 11) as f64 / (1u64 << 53) as f64),
            1 => T::of_bits(word >> (64 - digits)),
            _ => T::of((word >> 11) as f64 * 2f64.powi(-53 - (word & 63) as i32)),
        });
    }
    list
}

/// All pairs of hard numbers, and random directions.
pub(crate) fn pairs<T: Number>() -> (Vec<T>, Vec<T>) {
    let hard = hard::<T>();
    let mut list: Vec<(T, T)> = Vec::new();
    for i in 0..600 {
        let word = noise(i);
        let angle = (word >> 11) as f64 * 2f64.powi(-53 - (word & 31) as i32) * 3.2 - 1.6;
        list.push((T::of(angle.cos()), T::of(angle.sin())));
    }
    list.extend(hard.iter().flat_map(|&a| hard.iter().map(move |&b| (a, b))));
    list.into_iter().unzip()
}

/// Words whose leading zeros, or ones, are of every number; each with noise, zeros and ones after
/// it.
fn hard_words() -> Vec<u64> {
    let ends = [0, 1, u64::MAX, 1 << 63, (1 << 63) - 1, 1 << 61, 3 << 61];
    let noisy = (0..64).flat_map(|n| [noise(n) >> n, !(noise(n) >> n), 1 << n]);
    let words = ends.into_iter().chain(noisy).chain((0..300).map(noise));
    let after = |word: u64| {
        [
            0,
            u64::MAX,
            noise(word),
            noise(word) >> (word & 63),
            word << 32,
        ]
    };
    words
        .flat_map(|word| after(word).into_iter().flat_map(move |next| [word, next]))
        .collect()
}

/// Bits of probabilities and as many of azimuths.
pub(crate) fn bits<T: BatchNumber>() -> (Vec<TailBits<T>>, Vec<TurnBits<T>>) {
    let words = hard_words();
    let mut forwards = words.iter().copied().cycle();
    let mut backwards = words.iter().rev().copied().cycle();
    let mut next = || forwards.next().expect("a word");
    let mut other = || backwards.next().expect("a word");
    let each = |_| (T::tail_bits(&mut next), T::turn_bits(&mut other));
    (0..words.len()).map(each).unzip()
}
