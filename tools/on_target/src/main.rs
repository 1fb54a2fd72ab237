//! Builds the firmware under `examples/firmware`, runs it on emulated boards and compares what it
//! computes with this machine, bit by bit; shows of release images what is not linked into them.
//!
//! ```text
//! cargo run --release -p on_target -- run             # every law × type on every board
//! cargo run --release -p on_target -- hashes          # samples and evaluations: the first
//! thousands cargo run --release -p on_target -- hashes --full   # all of them: hours
//! cargo run --release -p on_target -- hashes --bless  # writes the expected hashes
//! cargo run --release -p on_target -- links           # proofs at link time
//! cargo run --release -p on_target -- c               # the C program
//! cargo run --release -p on_target -- self-test       # the power-on check, with planted faults
//! cargo run --release -p on_target -- cost            # instructions, flash, stack:
//! docs/measured/firmware_cost.* cargo run --release -p on_target -- cost --check    # a few of
//! them twice, against the table cargo run --release -p on_target -- shade           # small scenes
//! rendered on a Cortex-M4F
//! ```
//!
//! Needs QEMU (Debian: qemu-system-arm, qemu-system-misc) and, for `run`, defmt-print. What is
//! missing is printed as `SKIPPED: reason`, with the number of such lines at the end.

mod args;
mod boards;
mod build;
mod c;
mod cost;
mod difference;
mod failure;
mod hashes;
mod host;
mod links;
mod qemu;
mod report;
mod run;
mod self_test;
mod shade;
mod start;
mod types;

use args::{Args, Task};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let mut report = report::Report::default();
    let done = match Args::parse().task {
        Task::Run => run::run(&mut report),
        Task::Hashes(options) => hashes::run(&options, &mut report),
        Task::Links => links::run(&mut report),
        Task::C => c::run(&mut report),
        Task::SelfTest => self_test::run(&mut report),
        Task::Cost(options) => cost::run(&options, &mut report),
        Task::Shade(options) => shade::run(&options, &mut report),
    };
    report.finish(done)
}
