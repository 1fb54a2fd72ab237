//! Replays every committed fuzz seed on stable, and a few thousand inputs of a fixed generator.

use coslobe::rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// Inputs of the fixed generator, per target.
const EXPLORED: usize = 4000;

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

fn replay(target: &str, check: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../seeds")
        .join(target);
    let mut seeds: Vec<_> = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.expect("a readable folder").path())
        .collect();
    assert!(!seeds.is_empty(), "{} has no seeds", folder.display());
    seeds.sort();
    let seeds: Vec<_> = seeds
        .iter()
        .map(|path| (path, fs::read(path).expect("a readable seed")))
        .collect();
    for (path, data) in &seeds {
        run(check, data, &path.display().to_string());
    }
    // Half of the words are taken from the seeds, whose edges random words never meet.
    let mut rng = Pcg64Mcg::seed_from_u64(0x0C05_10BE);
    for round in 0..EXPLORED {
        let mut data = vec![0; rng.next_u32() as usize % 8 * 8 + 8];
        for word in data.chunks_exact_mut(8) {
            rng.fill_bytes(word);
            let (_, seed) = &seeds[rng.next_u32() as usize % seeds.len()];
            let at = rng.next_u32() as usize % (seed.len() / 8).max(1) * 8;
            if let (Some(edge), true) = (seed.get(at..at + 8), rng.next_u32() & 1 == 0) {
                word.copy_from_slice(edge);
            }
        }
        run(check, &data, &format!("{target}, round {round}"));
    }
}

#[test]
fn cos_power() {
    replay("cos_power", checks::cos_power::check);
}

#[test]
fn densities() {
    replay("densities", checks::densities::check);
}

#[test]
fn fixed() {
    replay("fixed", checks::fixed::check);
}

#[test]
fn frames() {
    replay("frames", checks::frames::check);
}

#[test]
fn points() {
    replay("points", checks::points::check);
}

#[test]
fn quantiles() {
    replay("quantiles", checks::quantiles::check);
}

#[test]
fn samples() {
    replay("samples", checks::samples::check);
}

#[test]
fn scene() {
    replay("scene", checks::scene::check);
}

#[test]
fn warps() {
    replay("warps", checks::warps::check);
}

#[test]
fn weights() {
    replay("weights", checks::weights::check);
}
