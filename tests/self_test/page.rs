//! docs/measured/self_test.md: what the test sees, as measured here.

use crate::alarms;
use crate::faults::name;
use crate::generators::{self, good};
use crate::samplers::{self, Verdict, judged};
use coslobe::Lambert;
use coslobe::self_test::{InSpace, Test};
use rayon::prelude::*;
use std::fmt::Write;

/// Bytes of a test: all it needs beside its functions' frames.
const RAM: usize = size_of::<Test<InSpace<f32, Lambert>>>();

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/measured/self_test.md");
const STOPS: [u16; 5] = [4096, 8192, 16384, 32768, 65535];
const SEEDS: u64 = 32;
const ALARM_SEEDS: u64 = 100_000;

/// A row: how many of the seeds are caught at each stop, and as what at the last.
fn row(fault: &str, run: impl Fn(u64) -> Vec<Verdict> + Send + Sync) -> String {
    let verdicts: Vec<_> = (0..SEEDS).into_par_iter().map(run).collect();
    let mut text = format!("| {fault} ");
    let last = verdicts.iter().filter_map(|v| name(v.last()?)).min();
    write!(text, "| {} ", last.as_deref().unwrap_or("not seen")).unwrap();
    for stop in 0..STOPS.len() {
        let caught = verdicts.iter().filter(|v| v[stop].is_err()).count() as u64;
        match caught {
            0 => text.push_str("| – "),
            SEEDS => text.push_str("| all "),
            _ => write!(text, "| {caught} ").unwrap(),
        }
    }
    text + "|\n"
}

fn head(what: &str) -> String {
    let mut text = format!("\n| {what} | named | ");
    for stop in STOPS {
        write!(text, "{stop} | ").unwrap();
    }
    text.trim_end().to_owned() + "\n|---|---|" + &"--:|".repeat(STOPS.len()) + "\n"
}

fn page() -> String {
    let mut text = format!(
        "<!-- Written by `cargo test --release --test self_test -- --ignored write_page`. -->\n\
         # What it costs and what it sees\n\n\
         A test takes {RAM} bytes of stack beside the frames of its functions, and no \
         static memory.\n\n\
         Instructions beside those of each `f32` direction of `Lambert` itself, and the deepest stack of a whole test, \
         painted: bytes, the test and its functions' frames included. By QEMU (`cargo run --release -p on_target -- \
         self-test`, which compares them with these):\n\n\
         | board | instructions a sample | stack of a whole test | in integers |\n|---|--:|--:|--:|\n\
         | M0 | 4125 | 1464 | 1464 |\n| M3 | 2527 | 1408 | 1400 |\n| M4F | 610 | 1416 | 1400 |\n\
         | RV32IMC | 2436 | 1384 | 1336 |\n\n\
         Caught, of {SEEDS} seeds, by `Alarm::OneInBillion` after so many samples; faults of a generator in \
         `Lambert` directions of `f32`, three words each.\n"
    );
    text += &head("fault of the generator (PCG but for this)");
    for (fault, make, _) in generators::FAULTS {
        let run = |seed| judged(InSpace::<f32, _>::new(Lambert), &mut make(seed), &STOPS);
        text += &row(fault, run);
    }
    text += &head("fault of the sampler");
    for (fault, run, _) in samplers::FAULTS {
        text += &row(fault, |seed| run(&mut good(seed), &STOPS));
    }
    let reports = alarms::reports(ALARM_SEEDS);
    text += "\nWhat is not seen at the default number of samples is for the host's tests: an exponent off by \
             5 %, tails below the grid of 24-bit uniforms, periods above half the samples, a bias of one \
             bit below 3 %, weak correlations.\n\n\
             False alarms: none of ";
    writeln!(
        text,
        "{ALARM_SEEDS} tests of 4096 good samples at `Alarm::OneInMillion`. Scores outside what χ² has with \
         probability p on a side:\n\n| p | expected | too even | too uneven |\n|--:|--:|--:|--:|"
    )
    .unwrap();
    for p in [1e-2, 1e-3, 1e-4, 1e-5] {
        let ([below, above], n) = alarms::beyond(&reports, p);
        writeln!(text, "| {p:e} | {:.0} | {below} | {above} |", p * n as f64).unwrap();
    }
    text
}

/// The table's figures are not repeated here (they take a minute); its faults and sizes are.
#[test]
fn committed_page_lists_every_fault_and_the_size() {
    let committed = include_str!("../../docs/measured/self_test.md");
    let stale = "docs/measured/self_test.md is out of date: cargo test --release --test self_test -- --ignored write_page";
    let faults = generators::FAULTS.iter().map(|(fault, ..)| fault);
    for fault in faults.chain(samplers::FAULTS.iter().map(|(fault, ..)| fault)) {
        assert!(
            committed.contains(&format!("| {fault} |")),
            "{fault}: {stale}"
        );
    }
    assert!(
        committed.contains(&format!("takes {} bytes", RAM)),
        "{stale}"
    );
}

#[test]
#[ignore = "writes docs/measured/self_test.md, a minute: cargo test --release --test self_test -- --ignored write_page"]
fn write_page() {
    std::fs::write(PATH, page()).unwrap();
}
