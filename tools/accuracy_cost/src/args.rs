//! What the command line may say.

use clap::{Parser, Subcommand};
use kit::accuracy::part::Part;
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

    /// Take the errors of our operations from accuracy_errors.json in the folder: measure costs
    /// alone.
    #[arg(long, conflicts_with = "errors")]
    pub(crate) keep_errors: bool,

    /// Take them from FILE: such a file, or the bare rows that tests/kit/src/accuracy/rows.rs
    /// writes.
    #[arg(long, value_name = "FILE")]
    pub(crate) errors: Option<PathBuf>,

    /// Write nothing: count instructions twice, expect no difference, and the right law of each
    /// sampler.
    #[arg(long, conflicts_with_all = ["keep_errors", "errors"])]
    pub(crate) check: bool,

    /// Measure errors alone, and of them the I-th of N parts, into part-I-of-N.json in the folder.
    #[arg(long, value_name = "I/N", conflicts_with_all = ["keep_errors", "errors", "check"])]
    pub(crate) part: Option<Part>,

    #[command(subcommand)]
    pub(crate) task: Option<Task>,
}

/// Parts of a run.
#[derive(Debug, clap::Args)]
pub(crate) struct MergeArgs {
    /// The files of all parts.
    #[arg(required = true)]
    pub(crate) parts: Vec<PathBuf>,

    /// The errors of the whole run, for --errors.
    #[arg(short, long, default_value = "docs/measured/accuracy_errors.json")]
    pub(crate) out: PathBuf,
}

/// Where to search, and for how long.
#[derive(Debug, clap::Args)]
pub(crate) struct SearchArgs {
    /// One law, such as Ball, instead of all.
    #[arg(long)]
    pub(crate) law: Option<String>,

    /// Climb for one operation alone, by its name in docs/bounds.md.
    #[arg(long)]
    pub(crate) op: Option<String>,

    /// One number type, such as f64; else those whose inputs are too many to try each.
    #[arg(long = "type", value_name = "TYPE")]
    pub(crate) number: Option<String>,

    /// Time for each law in each number type.
    #[arg(long, default_value_t = 10.0)]
    pub(crate) seconds: f64,

    /// Another seed searches elsewhere.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,

    /// The worst inputs: those of an earlier search are judged again, and where it goes on from.
    #[arg(long, default_value = "docs/measured/worst_inputs.json")]
    pub(crate) out: PathBuf,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// What valgrind runs.
    #[command(name = kit::study::count::SUBCOMMAND, hide = true)]
    CountCells,
    /// Prints the nanoseconds a direction that Lambert.warp_direction_slice takes over a file of
    /// f32 (native bytes).
    LambertDirections {
        /// All of u, then all of v.
        input: PathBuf,
        /// File for all x, then all y, then all z.
        #[arg(long)]
        values: Option<PathBuf>,
    },
    /// What valgrind runs for functions of slices.
    #[command(name = crate::vectors::SUBCOMMAND, hide = true)]
    CountSlices,
    /// Measures times alone; prints each limit, as a ratio to a peer in the same run, and whether
    /// it is reached.
    Limits {
        /// Exits with 1 where a limit is missed or not measured.
        #[arg(long)]
        strict: bool,
    },
    /// Counts instructions an element of loops that shall be vectors, at SSE2 and AVX2: fails where
    /// one is none.
    Vectors,
    /// Merges all parts of a run.
    Merge(MergeArgs),
    /// Searches for the inputs with the largest errors.
    Search(SearchArgs),
    /// Prints the nanoseconds an element that Disk.quantile takes over a file of f64 (native
    /// bytes).
    DiskQuantile {
        /// The probabilities.
        input: PathBuf,
        /// File for θ and cos θ of each, as pairs of f64.
        #[arg(long)]
        values: Option<PathBuf>,
    },
}
