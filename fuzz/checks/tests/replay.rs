//! Replays every committed fuzz seed on stable, and inputs of a fixed generator.

use coslobe::rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs `check` and names the input in hex where it fails, so that it can become a seed.
fn run(check: fn(&[u8]), data: &[u8], origin: &str) {
    if let Err(panic) = catch_unwind(AssertUnwindSafe(|| check(data))) {
        let hex: String = data.iter().map(|byte| format!("{byte:02x}")).collect();
        let why = panic
            .downcast::<String>()
            .map_or_else(|_| String::new(), |why| *why);
        panic!("{origin}: {why}\ninput: {hex}");
    }
}

/// The seeds of a numeric target: a line each, in hex.
fn lines(text: &str) -> Vec<Vec<u8>> {
    let byte = |pair: &[u8]| {
        let pair = str::from_utf8(pair).expect("hex");
        u8::from_str_radix(pair, 16).expect("hex")
    };
    let lines = text
        .lines()
        .map(|line| line.split('#').next().unwrap_or("").trim());
    lines
        .map(|line| line.as_bytes().chunks(2).map(byte).collect())
        .collect()
}

fn replay(target: &str, check: fn(&[u8]), explored: usize, seeds: &[Vec<u8>]) {
    assert!(!seeds.is_empty(), "{target} has no seeds");
    for data in seeds {
        run(check, data, &format!("{target}, a seed"));
    }
    let mut rng = Pcg64Mcg::seed_from_u64(0x0C05_10BE);
    for round in 0..explored {
        let mut data = vec![0; 4 + 8 * (rng.next_u32() as usize % 7)];
        rng.fill_bytes(&mut data);
        for word in data[4..].chunks_exact_mut(8) {
            word.copy_from_slice(&edge(&mut rng).to_le_bytes());
        }
        run(check, &data, &format!("{target}, round {round}"));
    }
}

/// Numbers of either format that even words never meet: ends and their neighbours, and all
/// magnitudes.
fn edge(rng: &mut Pcg64Mcg) -> u64 {
    const ENDS: [f64; 12] = [
        0.0,
        1.0,
        0.5,
        0.125,
        f64::MIN_POSITIVE,
        1e-300,
        f64::INFINITY,
        f64::NAN,
        FRAC_PI_2,
        FRAC_1_SQRT_2,
        3.0,
        1e30,
    ];
    let word = rng.next_u64();
    let [kind, end, step, shift] = [0, 8, 16, 24].map(|n| rng.next_u32() >> n & 0xFF);
    let end = ENDS[end as usize % ENDS.len()];
    let small = (-f64::from(step) / 256.0 * 700f64.powf(f64::from(shift) / 256.0)).exp();
    let part = word as f64 * 2f64.powi(-64);
    match kind % 8 {
        0 => (end.to_bits() ^ (word & 1) << 63)
            .wrapping_add(u64::from(step % 5))
            .wrapping_sub(2),
        1 => u64::from(
            ((end as f32).to_bits() ^ (word as u32 & 1) << 31)
                .wrapping_add(step % 5)
                .wrapping_sub(2),
        ),
        2 => (small * part).to_bits(),
        3 => u64::from(((small * part) as f32).to_bits()),
        4 => word >> (shift % 64),
        5 => !(word >> (shift % 64)),
        _ => word,
    }
}

#[test]
fn floats() {
    replay(
        "floats",
        checks::floats::check,
        200_000,
        &lines(include_str!("../../seeds/floats.hex")),
    );
}

#[test]
fn integers() {
    replay(
        "integers",
        checks::integers::check,
        200_000,
        &lines(include_str!("../../seeds/integers.hex")),
    );
}

#[cfg(feature = "scene")]
#[test]
fn scene() {
    use std::{fs, path::Path};
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../seeds/scene");
    let seeds: Vec<_> = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| fs::read(entry.expect("a readable folder").path()).expect("a readable seed"))
        .collect();
    replay("scene", checks::scene::check, 4000, &seeds);
}
