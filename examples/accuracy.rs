//! Measures the error of every operation of every law and writes `docs/accuracy.md`.
//!
//! ```text
//! cargo run --release --example accuracy -- --stride 1    # every f32; about an hour on two cores
//! cargo run --release --example accuracy -- --out /tmp/quick.md
//! ```

#[path = "../tests/accuracy/mod.rs"]
mod accuracy;

use accuracy::format::{Format, Subject};
use accuracy::inputs::{exponents, sample};
use accuracy::measure::{OPERATIONS, Tally, at_angle, at_tail, sweep};
use accuracy::monotone;
use accuracy::reference::Id;
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
}

fn bar(name: &'static str, total: u64) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{msg:24} {bar:40} {percent}% {eta}").expect("a template");
    ProgressBar::new(total).with_style(style).with_message(name)
}

/// f32: every `stride`-th argument.
fn swept(ids: &[Id], stride: u64) -> (Vec<Subject<f32>>, Tally) {
    let subjects = Subject::all(ids);
    let progress = bar("f32", (f32::TOP_ANGLE + f32::HALF_BITS) / stride);
    let step = |n| progress.inc(n);
    let angles = sweep(&subjects, f32::TOP_ANGLE, stride, at_angle, step);
    let tally = angles.merge(sweep(&subjects, f32::HALF_BITS, stride, at_tail, step));
    progress.finish_and_clear();
    (subjects, tally)
}

/// n stratified arguments.
fn sampled<T: Format>(ids: &[Id], n: u64) -> (Vec<Subject<T>>, Tally) {
    let subjects = Subject::all(ids);
    let progress = bar(T::NAME, 2 * n);
    let step = |n| progress.inc(n);
    let angles = sample(&subjects, T::TOP_ANGLE, n, at_angle, step);
    let tally = angles.merge(sample(&subjects, T::HALF_BITS, n, at_tail, step));
    progress.finish_and_clear();
    (subjects, tally)
}

fn table<T: Format>(
    out: &mut String,
    (subjects, tally): &(Vec<Subject<T>>, Tally),
    exhaustive: bool,
) {
    *out += "\n| law | operation | max ulp | inputs | worst input | correctly rounded |\n";
    *out += "|---|---|---|---|---|---|\n";
    for (s, row) in subjects.iter().zip(&tally.0) {
        let name = match s.id {
            Id::CosPower(k) => format!("CosPower({k:e})"),
            id => id.name().to_owned(),
        };
        for ((_, operation), worst) in OPERATIONS.iter().zip(row) {
            if worst.tried == 0 {
                continue;
            }
            let kind = if exhaustive { "exhaustive" } else { "observed" };
            let share = 100.0 * worst.correct as f64 / worst.tried as f64;
            writeln!(
                out,
                "| {name} | {operation} | {:.3} | {kind} ({}) | {:#x} = {:e} | {share:.2} % |",
                worst.ulps,
                worst.tried,
                worst.input,
                T::of_bits(worst.input).wide()
            )
            .expect("writing to a string");
        }
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
        let single = monotone::strided(&Subject::<f32>::new(id), stride).0;
        let double = monotone::sampled(&Subject::<f64>::new(id), samples).0;
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
         1 − u is exact for u ≥ ½. [Allowed errors](bounds.md) are what the tests enforce.\n\n## f32\n",
    );
    table(
        &mut out,
        &swept(&Id::FIXED, arguments.stride),
        arguments.stride == 1,
    );
    table(
        &mut out,
        &sampled::<f32>(&exponents::<f32>(), arguments.samples / 10),
        false,
    );
    out += "\n## f64\n";
    table(
        &mut out,
        &sampled::<f64>(&Id::FIXED, arguments.samples),
        false,
    );
    table(
        &mut out,
        &sampled::<f64>(&exponents::<f64>(), arguments.samples / 10),
        false,
    );
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
    ExitCode::SUCCESS
}
