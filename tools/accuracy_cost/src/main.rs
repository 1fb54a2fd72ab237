//! What accuracy costs: errors, instructions, time and random words of every operation of every
//! law in every number type, and of what others would write instead.
//!
//! ```text
//! cargo run --release -p accuracy_cost                    # strided errors: some minutes
//! cargo run --release -p accuracy_cost -- --stride 1 --samples 3000000   # every f32: hours
//! cargo run --release -p accuracy_cost -- --keep-errors   # costs alone, errors as they stand
//! cargo run --release -p accuracy_cost -- --check         # counts twice, expects no difference
//! cargo run --release -p accuracy_cost -- search --seconds 200   # the worst inputs of f64 and
//! CosPower: an hour
//! ```
//!
//! Writes `accuracy_cost.{csv,md,svg}`, `accuracy_time.svg`, `accuracy_errors.json` and
//! `stability.svg`. Needs valgrind for the instructions (`apt install valgrind`);
//! `docs/measured/scipy.csv` comes from `tools/scipy_peer.py`.

mod args;
mod arrays;
mod catalog;
mod check;
mod contender;
mod directions;
mod disk_quantile;
mod fronts;
mod judged;
mod limits;
mod machine;
mod mitsuba;
mod page;
mod pareto;
mod parts;
mod peers;
mod row;
mod scipy;
mod search;
mod slices;
mod stability;
mod study;
mod summary;
mod tables;
mod time;
mod vectors;

use args::{Args, Task};
use clap::Parser;
use kit::study::count;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args = Args::parse();
    let done = match &args.task {
        Some(Task::CountCells) => {
            let mut all = catalog::Counted::new();
            count::child(all.cells().map(|c| [&mut *c.run, &mut *c.empty]));
            Ok(())
        }
        Some(Task::CountSlices) => {
            vectors::child();
            Ok(())
        }
        Some(Task::LambertDirections { input, values }) => {
            directions::run(input, values.as_deref()).map_err(Into::into)
        }
        Some(Task::Limits { strict }) => limits::run(&args.out, *strict),
        Some(Task::Vectors) => vectors::run(),
        Some(Task::Merge(args)) => parts::merge(args),
        Some(Task::Search(args)) => search::run(args),
        Some(Task::DiskQuantile { input, values }) => {
            disk_quantile::run(input, values.as_deref()).map_err(Into::into)
        }
        None => match args.part {
            Some(part) => parts::one(&args, part),
            None if args.check => check::run(),
            None => study::run(&args),
        },
    };
    output::exit_code("accuracy_cost", done)
}
