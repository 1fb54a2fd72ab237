//! The random words by counting: even, and without a tie between neighbours.

use coslobe::rand_core::Rng;
use shade_core::{Effect, Place, Stream};

/// Words at neighbouring places along one coordinate of the counter.
fn along(f: impl Fn(u32) -> (Place, u32, Effect)) -> Vec<u32> {
    let words = (0..1 << 14).map(|i| {
        let (place, bounce, effect) = f(i);
        Stream::new(place, bounce, effect, 0, &mut ()).next_u32()
    });
    words.collect()
}

/// Largest deviation, in standard errors, of each bit's mean and of its change between neighbours.
fn worst(words: &[u32]) -> f64 {
    let n = words.len() as f64;
    let z = |count: usize| (count as f64 - n / 2.0).abs() / (n / 4.0).sqrt();
    let bits = 0..32;
    let even = bits
        .clone()
        .map(|b| z(words.iter().filter(|&&w| w >> b & 1 != 0).count()));
    let changes = bits.map(|b| {
        z(words
            .windows(2)
            .filter(|w| (w[0] ^ w[1]) >> b & 1 != 0)
            .count())
    });
    even.chain(changes).fold(0.0, f64::max)
}

#[test]
fn neighbours_are_independent() {
    let place = |pixel, sample, seed| Place {
        pixel,
        sample,
        seed,
    };
    let runs = [
        along(|i| (place(i, 0, 0), 0, Effect::Diffuse)),
        along(|i| (place(7, i, 0), 0, Effect::Diffuse)),
        along(|i| (place(7, 3, i), 0, Effect::Diffuse)),
        along(|i| (place(7, 3, 1), i, Effect::Diffuse)),
    ];
    // 256 figures: 4.7 standard errors are met by chance once in a thousand runs.
    for words in &runs {
        assert!(worst(words) < 4.7, "{}", worst(words));
    }
    // A counter is no generator.
    assert!(worst(&(0..1 << 14).collect::<Vec<u32>>()) > 4.7);
    assert!(
        worst(
            &(0..1u32 << 14)
                .map(|i| i.wrapping_mul(0x9E37_79B9))
                .collect::<Vec<u32>>()
        ) > 4.7
    );
}

/// No two of the streams of a sample, nor blocks of a stream, are the same.
#[test]
fn streams_differ() {
    let place = Place {
        pixel: 1,
        sample: 2,
        seed: 3,
    };
    let mut seen = std::collections::BTreeSet::new();
    for effect in Effect::ALL {
        for bounce in 0..64 {
            for part in 0..4 {
                let mut meter = ();
                let mut stream = Stream::new(place, bounce, effect, part, &mut meter);
                // Two blocks of four words.
                for _ in 0..4 {
                    assert!(seen.insert(stream.next_u64()), "{effect:?} {bounce} {part}");
                }
            }
        }
    }
}
