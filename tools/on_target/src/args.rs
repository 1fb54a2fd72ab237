//! What the command line may say.

use clap::{Parser, Subcommand};
use std::path::PathBuf;

/// Runs the firmware on emulated boards and compares it with this machine.
#[derive(Debug, Parser)]
#[command(name = "on_target")]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) task: Task,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Task {
    /// Builds and runs every law in every number type, and the start, on every board.
    Run,
    /// Compares hashes of samples and evaluations on every board with the committed ones.
    Hashes(Hashes),
    /// Proves of release images: no panic, allocation, static RAM, soft-double or law that is not
    /// used.
    Links,
    /// Links a C program with the laws, runs it here and on every board; checks the C header.
    C,
    /// Runs the power-on check on every board: with a good generator, and with planted faults.
    SelfTest,
    /// Counts instructions, flash, stack and words of every operation on every board; writes the
    /// tables and the plot.
    Cost(Cost),
    /// Renders small scenes on the M4F: the host's pixels, and no code of effects that they do not
    /// call for.
    Shade(Shade),
}

#[derive(Debug, clap::Args)]
pub(crate) struct Shade {
    /// Writes docs/measured/shade_firmware.md instead of comparing with it.
    #[arg(long)]
    pub(crate) write: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct Hashes {
    /// All 2²⁰ samples and 2¹⁴ inputs instead of the first 4096 and 1024: hours.
    #[arg(long)]
    pub(crate) full: bool,

    /// Compares up to this count; the checkpoints are powers of 4 from 64 on.
    #[arg(long, value_name = "COUNT", conflicts_with = "full")]
    pub(crate) last: Option<u32>,

    /// Only the boards (M0, M3, M4F, RV32IMC) or the host named.
    #[arg(long, value_name = "BOARD")]
    pub(crate) only: Vec<String>,

    /// Only the number types named, as `f32` or `Precise<f64>`.
    #[arg(long = "type", value_name = "TYPE")]
    pub(crate) types: Vec<String>,

    /// Unoptimised images with overflow checks, on boards that have room for them.
    #[arg(long)]
    pub(crate) debug: bool,

    /// Writes the host's hashes as the expected ones: a value-breaking change.
    #[arg(long, conflicts_with_all = ["last", "only", "types", "debug", "planted"])]
    pub(crate) bless: bool,

    /// Changes the last bit of one result in the images; has to fail and name it.
    #[arg(long)]
    pub(crate) planted: bool,
}

#[derive(Debug, clap::Args)]
pub(crate) struct Cost {
    /// Folder for the tables and the plot; `accuracy_cost.csv` in it has the errors.
    #[arg(long, default_value = "docs/measured")]
    pub(crate) out: PathBuf,

    /// Writes nothing: some cells twice, expected to be equal and as the folder's table has them.
    #[arg(long)]
    pub(crate) check: bool,

    /// Writes firmware_builds.md alone: what overflow checks and levels for size change.
    #[arg(long, conflicts_with = "check")]
    pub(crate) builds: bool,
}
