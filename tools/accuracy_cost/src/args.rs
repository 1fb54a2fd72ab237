//! What the command line may say.

use clap::{Parser, Subcommand};
use std::path::PathBuf;

/// Measures errors and costs of every operation, and writes tables and plots of both.
#[derive(Debug, Parser)]
#[command(name = "accuracy_cost")]
pub(crate) struct Args {
    /// Judge every STRIDE-th f32; 1 is exhaustive and takes hours.
    #[arg(long, default_value_t = 10_007, value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) stride: u64,

    /// Stratified f64 angles to judge, and as many probabilities.
    #[arg(long, default_value_t = 300_000, value_parser = clap::value_parser!(u64).range(30..))]
    pub(crate) samples: u64,

    /// Folder for the tables and plots; other files in it are left alone.
    #[arg(long, default_value = "docs/measured")]
    pub(crate) out: PathBuf,

    /// Take the errors of our operations from accuracy_errors.json in the folder: measure costs alone.
    #[arg(long, conflicts_with = "errors")]
    pub(crate) keep_errors: bool,

    /// Take them from FILE: such a file, or the bare rows that tests/kit/src/accuracy/rows.rs writes.
    #[arg(long, value_name = "FILE")]
    pub(crate) errors: Option<PathBuf>,

    /// Write nothing: count instructions twice, expect no difference, and the right law of each sampler.
    #[arg(long, conflicts_with_all = ["keep_errors", "errors"])]
    pub(crate) check: bool,

    #[command(subcommand)]
    pub(crate) task: Option<Task>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// What valgrind runs.
    #[command(name = kit::study::count::SUBCOMMAND, hide = true)]
    CountCells,
    /// Prints the nanoseconds an element that Disk.quantile takes over a file of f64 (native bytes).
    DiskQuantile {
        /// The probabilities.
        input: PathBuf,
        /// File for θ and cos θ of each, as pairs of f64.
        #[arg(long)]
        values: Option<PathBuf>,
    },
}
