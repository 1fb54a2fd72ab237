//! A path tracer on `coslobe` that simulates only the effects that its scene calls for.
//!
//! ```text
//! cargo run --release -p shade -- examples/shade/scenes/all.toml -o all.png
//! ```

mod args;
mod image;
mod job;
mod plan;
mod render;
mod table;
mod tiles;
mod types;

use args::Args;
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    output::exit_code("shade", job::run(&Args::parse()))
}
