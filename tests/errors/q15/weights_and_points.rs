//! Weights on every cosine, distances on every cosine and v.

use super::Worst;
use coslobe::CosSin;
use fixed::types::{I1F15, U16F16};
use kit::integer::short::{Pair, Q15, Subject, subjects};
use rayon::prelude::*;

const Q32: f64 = 4294967296.0;

fn at(cos: i16) -> Pair {
    CosSin {
        cos: I1F15::from_bits(cos),
        sin: I1F15::ZERO,
    }
}

/// In the larger of 2⁻¹⁶ and 2⁻¹⁴ of the weight.
fn weight(law: &Subject, x: u32) -> f64 {
    let got = (law.lambert_weight)(at(x as i16));
    let want = match x as i16 {
        ..0 => return f64::from(got),
        0 if law.k > 1 => return f64::from(U16F16::MAX - got),
        cos => law.weight_at(f64::from(cos) / Q15),
    };
    let want = (want * 65536.0).min(Q32 - 1.0);
    (f64::from(got.to_bits()) - want).abs() / (want / 2f64.powi(14)).max(1.0)
}

/// The cosine in the upper half of the word, v in the lower.
fn distance(law: &Subject, radius: i16, x: u32) -> f64 {
    let (cos, v) = ((x >> 16) as i16 & i16::MAX, x as u16);
    let (cosine, share) = (f64::from(cos) / Q15, f64::from(v) / 65536.0);
    let want = law.distance(f64::from(radius), cosine, share);
    (f64::from((law.distance)(radius, at(cos), v)) - want).abs()
}

/// [weight, distance] of each law, in the order of `Id::FIXED`.
const BOUNDS: [[f64; 2]; 6] = [
    [1.4, 1.25],
    [0.0, 0.51],
    [0.55, 0.51],
    [2.75, 1.25],
    [1.5, 0.51],
    [0.0, 0.51],
];

#[test]
fn weights_on_every_cosine() {
    for (law, [bound, _]) in subjects().iter().zip(BOUNDS) {
        let name = law.name;
        let Worst(error, x) = Worst::over(0..1 << 16, |x| weight(law, x));
        println!("{name} weight: {error:.3} at {x:#06x} (bound {bound})");
        assert!(error <= bound, "{name}: {error} at {x:#06x}");
    }
}

fn distances(stride: u32) {
    for (law, [_, bound]) in subjects().iter().zip(BOUNDS) {
        let name = law.name;
        // The others do not read v.
        let is_solid = ["Disk", "Ball"].contains(&name);
        let stride = if is_solid { stride } else { 1 << 16 };
        for radius in [1, 100, 5_793, i16::MAX >> 2] {
            let Worst(error, x) = (0..(1u32 << 31) / stride)
                .into_par_iter()
                .map(|i| Worst(distance(law, radius, i * stride), i * stride))
                .reduce(|| Worst(-1.0, 0), Worst::larger);
            println!("{name} distance, radius {radius}: {error:.3} at {x:#010x} (bound {bound})");
            assert!(
                error <= bound,
                "{name}, radius {radius}: {error} at {x:#010x}"
            );
        }
    }
}

#[test]
fn distances_in_strides() {
    distances(1021);
}

#[test]
#[ignore = "2³¹ pairs a radius: cargo test --release --test errors q15::weights -- --ignored --nocapture"]
fn distances_on_every_pair() {
    distances(1);
}

/// Another law's, a root that is none.
#[test]
fn wrong_ones_are_caught() {
    let [disk, _, _, ball, shell, _] = subjects()[..] else {
        panic!("six laws");
    };
    let lambert_weight = shell.lambert_weight;
    let Worst(error, _) = Worst::over(0..1 << 16, |x| {
        weight(
            &Subject {
                lambert_weight,
                ..disk
            },
            x,
        )
    });
    assert!(error > 100.0);
    for (law, distance_of) in [(disk, ball), (ball, shell)] {
        let wrong = Subject {
            distance: distance_of.distance,
            ..law
        };
        let inputs = (0..1 << 31).step_by(100_003);
        assert!(Worst::over(inputs, |x| distance(&wrong, 8_191, x)).0 > 100.0);
    }
}
