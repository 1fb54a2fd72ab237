//! Measures the error of every operation of every law and writes `docs/accuracy.md`.
//!
//! ```text
//! cargo run --release --example accuracy -- --stride 1    # every f32; about an hour on two cores
//! cargo run --release --example accuracy -- --out /tmp/quick.md
//! ```

#[path = "../tests/accuracy/mod.rs"]
mod accuracy;

use accuracy::monotone;
use accuracy::reference::Id;
use accuracy::rows::{Row, measure_all, to_json, total_inputs};
use accuracy::subject::Tiers;
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Measures the error of every operation and writes it as a table.
#[derive(Parser)]
struct Arguments {
    /// Take every STRIDE-th f32; 1 is exhaustive.
    #[arg(long, default_value_t = 1009, value_parser = clap::value_parser!(u64).range(1..))]
    stride: u64,
    /// Number of stratified f64 angles, and as many probabilities.
    #[arg(long, default_value_t = 3_000_000, value_parser = clap::value_parser!(u64).range(3..))]
    samples: u64,
    /// File to write.
    #[arg(long, default_value = "docs/accuracy.md")]
    out: PathBuf,
    /// File to write the rows to, as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
}

fn table(out: &mut String, rows: &[&Row]) {
    *out += "\n| law | operation | max ulp | inputs | worst input | correctly rounded |\n";
    *out += "|---|---|---|---|---|---|\n";
    for row in rows {
        let kind = if row.exhaustive {
            "exhaustive"
        } else {
            "observed"
        };
        writeln!(
            out,
            "| {} | {} | {:.3} | {kind} ({}) | {} = {:e} | {:.2} % |",
            row.law,
            row.operation,
            row.max_ulp,
            row.inputs,
            row.worst_input_hex,
            row.worst_input,
            row.correctly_rounded_percent
        )
        .expect("writing to a string");
    }
}

fn monotone_table(out: &mut String, stride: u64, samples: u64) {
    let exhaustive = if stride == 1 {
        "exhaustive".into()
    } else {
        format!("every {stride}th p")
    };
    writeln!(
        out,
        "\n| law | f32 ({exhaustive}) | f64 ({samples} p) |\n|---|---|---|"
    )
    .expect("a string");
    for id in Id::FIXED {
        let single = monotone::strided(&f32::tiers(id)[0], stride).0;
        let double = monotone::sampled(&f64::tiers(id)[0], samples).0;
        writeln!(out, "| {} | {single} | {double} |", id.name()).expect("a string");
    }
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let mut out = String::from(
        "# Observed errors\n\n\
         Written by `cargo run --release --example accuracy -- --stride 1`; do not edit. Errors are in\n\
         ulps of the true value. f32 is judged against f64 formulas, f64 against double-double, both\n\
         of them checked against Arb's tables in `tests/reference/`. For operations on pairs the input\n\
         is the angle whose rounded (cos θ, sin θ) was the pair; planar laws are tried at ±θ; for\n\
         operations on probabilities it is the nearer tail p, which covers the whole domain since\n\
         1 − u is exact for u ≥ ½. [Allowed errors](bounds.md) are what the tests enforce.\n",
    );
    let total = total_inputs(arguments.stride, arguments.samples);
    let style =
        ProgressStyle::with_template("{msg} {bar:40} {percent}% {eta}").expect("a template");
    let progress = ProgressBar::new(total)
        .with_style(style)
        .with_message("inputs");
    let rows = measure_all(arguments.stride, arguments.samples, |n| progress.inc(n));
    progress.finish_and_clear();
    let mut types: Vec<&str> = rows.iter().map(|row| row.tier.as_str()).collect();
    types.sort();
    types.dedup();
    for tier in types {
        writeln!(out, "\n## {tier}").expect("a string");
        let (named, powers): (Vec<_>, Vec<_>) = rows
            .iter()
            .filter(|row| row.tier == tier)
            .partition(|row| !row.law.starts_with("CosPower"));
        table(&mut out, &named);
        table(&mut out, &powers);
    }
    out += "\n## Monotone quantiles\n\nPairs of neighbours p where `quantile` or `isf` steps back or, for a planar law, fails to mirror.\n";
    monotone_table(&mut out, arguments.stride, arguments.samples);
    // Beside the target first, so that a failure leaves no half-written table.
    let partial = arguments.out.with_extension("partial");
    let written =
        std::fs::write(&partial, out).and_then(|()| std::fs::rename(&partial, &arguments.out));
    if let Err(error) = written {
        eprintln!(
            "cannot write {}: {error}; expected a writable file",
            arguments.out.display()
        );
        let _ = std::fs::remove_file(&partial);
        return ExitCode::FAILURE;
    }
    if let Some(path) = arguments.json {
        let text = to_json(&rows).expect("rows have no keys but names");
        if let Err(error) = std::fs::write(&path, text) {
            eprintln!(
                "cannot write {}: {error}; expected a writable file",
                path.display()
            );
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
