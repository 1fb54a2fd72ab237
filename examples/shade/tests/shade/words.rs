//! The random words by counting: even, and without a tie between neighbours.

use coslobe::rand_core::Rng;
use coslobe::{CosPower, Fast, Precise};
use shade_core::{Aligned, AnyPlanar, AnySpatial, Effect, Number, Place, Sampling, Stream, Vector};

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

/// What every type draws from a stream of aligned words, and its density: of each law of space,
/// then of flatland.
fn drawn<T: Number>(sample: u32) -> Vec<f64> {
    fn one<V: Vector, L: Sampling<V>>(law: &L, sample: u32) -> Vec<f64> {
        let axis = V::from_fn(|i| V::T::from_f64([0.48, 0.6, 0.64][i])).unit();
        let place = Place {
            pixel: 5,
            sample,
            seed: 1,
        };
        let mut meter = Aligned::<V::T>::default();
        let mut words = Stream::new(place, 2, Effect::Gloss, 0, &mut meter);
        let (d, _, density) = law.draw(axis, &mut words);
        let mut all: Vec<f64> = (0..V::DIM).map(|i| d.at(i).into()).collect();
        all.push(density.into());
        all
    }
    let power = CosPower::new(T::from_f64(20.0)).expect("an exponent");
    let space = [
        AnySpatial::Lambert,
        AnySpatial::SphereShell,
        AnySpatial::Ball,
        AnySpatial::Power(power),
    ];
    let flat = [
        AnyPlanar::CircleArc,
        AnyPlanar::CircleShell,
        AnyPlanar::Disk,
    ];
    let space = space.iter().flat_map(|l| one::<[T; 3], _>(l, sample));
    space
        .chain(flat.iter().flat_map(|l| one::<[T; 2], _>(l, sample)))
        .collect()
}

/// Their pictures are compared: a type that draws other directions would look wrong by the noise.
#[test]
fn every_type_draws_the_same_directions() {
    for sample in 0..1000 {
        let want = drawn::<f64>(sample);
        for (have, error) in [
            (drawn::<f32>(sample), 1e-5),
            (drawn::<Fast<f32>>(sample), 4e-3),
            (drawn::<Precise<f32>>(sample), 1e-5),
            (drawn::<Precise<f64>>(sample), 1e-12),
        ] {
            for (a, b) in have.iter().zip(&want) {
                assert!(
                    (a - b).abs() <= error * b.abs().max(1.0),
                    "{sample}: {have:?} {want:?}"
                );
            }
        }
    }
}
