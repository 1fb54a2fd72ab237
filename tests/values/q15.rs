//! Value stability: a hash of every result on all words and of 10⁵ samples, as committed in
//! `tests/golden/fixed16.txt`.
//!
//! If a change is meant, mark it "value-breaking" in the changelog and run
//! `COSLOBE_BLESS=1 cargo test --test values`.

use coslobe::Fixed16;
use fixed::types::I1F15;
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use kit::integer::short::{Subject, subjects};
use rand_pcg::Pcg32;
use std::fmt::Write;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/fixed16.txt");

/// FNV-1a, word by word.
fn hash(words: impl Iterator<Item = u16>) -> u64 {
    words
        .flat_map(u16::to_le_bytes)
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        })
}

fn functions(law: &Subject, lines: &mut String) {
    let mut line = |operation: &str, of: &dyn Fn(u16) -> [u16; 2]| {
        let hash = hash((0..=u16::MAX).flat_map(of));
        writeln!(lines, "{} {operation}: {hash:016x}", law.name).expect("a string grows");
    };
    let bits = |x: I1F15| x.to_bits() as u16;
    line("warp", &|u| {
        let at = (law.warp)(u);
        [bits(at.cos), bits(at.sin)]
    });
    line("warp_sf", &|q| {
        let at = (law.warp_sf)(q);
        [bits(at.cos), bits(at.sin)]
    });
    line("unwarp", &|u| {
        let at = (law.warp)(u);
        [(law.unwarp)(at), (law.unwarp_sf)(at)]
    });
    line("densities", &|u| {
        [(law.density)((law.warp)(u)), (law.pdf)(u as i16)]
    });
    line("tails", &|x| [(law.cdf)(x as i16), (law.sf)(x as i16)]);
    line("quantiles", &|p| {
        [(law.quantile)(p) as u16, (law.isf)(p) as u16]
    });
}

/// Lines of samples.
struct Samples(String);

impl IntegerVisitor for Samples {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        let mut rng = Pcg32::new(1, 2);
        let directions = (0..100_000).flat_map(|_| {
            let drawn = Fixed16(law).sample(&mut rng);
            let drawn: Vec<_> = drawn.as_ref().iter().map(|x| x.to_bits() as u16).collect();
            drawn
        });
        let hash = hash(directions);
        writeln!(self.0, "{} samples: {hash:016x}", L::ID).expect("a string grows");
    }
}

#[test]
fn values_are_stable() {
    let mut lines = String::new();
    for law in subjects() {
        functions(&law, &mut lines);
    }
    let mut samples = Samples(lines);
    every_integer_law(&mut samples);
    let lines = samples.0;
    if std::env::var_os("COSLOBE_BLESS").is_some() {
        std::fs::write(FILE, &lines).expect("the golden file is writable");
        return;
    }
    let golden = std::fs::read_to_string(FILE).unwrap_or_default();
    let changed: Vec<_> = lines
        .lines()
        .zip(golden.lines().chain(std::iter::repeat("nothing")))
        .filter(|(found, expected)| found != expected)
        .collect();
    assert!(
        changed.is_empty() && lines.lines().count() == golden.lines().count(),
        "value-breaking change, (found, expected): {changed:#?}"
    );
    let disk = subjects()[0];
    let spoiled = Subject {
        isf: |p| disk_isf(p) ^ i16::from(p == 7),
        ..disk
    };
    let mut other = String::new();
    functions(&spoiled, &mut other);
    assert!(!lines.starts_with(&other), "one wrong bit is found");
}

fn disk_isf(p: u16) -> i16 {
    let disk = subjects()[0];
    (disk.isf)(p)
}
