//! What overflow checks and the compiler's levels for size change in a direction.

use super::images::{PROFILE, Settings, Subject, ours};
use super::measure;
use super::row::Row;
use super::study::Study;
use crate::boards::{BOARDS, Board};
use crate::failure::Result;
use indicatif::ProgressBar;
use rayon::prelude::*;

const LEVEL: &str = "CARGO_PROFILE_RELEASE_OPT_LEVEL";

const BUILDS: [Settings; 4] = [
    PROFILE,
    Settings {
        title: "3, `overflow-checks`",
        variables: &[("CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS", "true")],
    },
    Settings {
        title: "`s`",
        variables: &[(LEVEL, "s")],
    },
    Settings {
        title: "`z`",
        variables: &[(LEVEL, "z")],
    },
];

/// The smallest processor, and one with a unit for floats.
const ON: [&str; 2] = ["M0", "M4F"];
/// A binary whose operations are the number types.
const DIRECTIONS: Subject = ours("directions", "", "");

/// How many images are built.
pub(crate) const COUNT: u64 = (ON.len() * BUILDS.len()) as u64;

/// The page.
pub(crate) fn page(rustc: &str, bar: &ProgressBar) -> Result<String> {
    let boards: Vec<&Board> = BOARDS.iter().filter(|b| ON.contains(&b.name)).collect();
    let tables = boards.into_par_iter().map(|board| table(board, rustc, bar));
    let tables: Result<Vec<String>> = tables.collect();
    Ok(format!(
        "# What the compiler's settings change\n\n\
         Written by `cargo run --release -p on_target -- cost --builds`; do not edit. A `Lambert` direction, `XorShiftRng`\n\
         included, compiled by {rustc} with fat LTO and one codegen unit: mean instructions, bytes of flash, bytes of\n\
         stack, counted as in [the table of all operations](firmware_cost.md). The whole program is built at that opt-level,\n\
         `libm` always without overflow checks. No build links a panic.\n{}",
        tables?.concat()
    ))
}

/// Types down, builds across.
fn table(board: &Board, rustc: &str, bar: &ProgressBar) -> Result<String> {
    let mut columns: Vec<Vec<Row>> = Vec::new();
    for build in BUILDS {
        let study = Study::default();
        columns.push(measure::built(board, &DIRECTIONS, build, &[], &study, rustc)?.rows);
        bar.inc(1);
    }
    let titles = BUILDS.map(|build| build.title).join(" | ");
    let mut text = format!(
        "\n## {}: instructions, flash, stack\n\n| type | {titles} |\n|---|{}\n",
        board.name,
        "---|".repeat(BUILDS.len())
    );
    for (i, first) in columns[0].iter().enumerate() {
        let cells: Vec<_> = columns.iter().map(|rows| cell(&rows[i])).collect();
        text += &format!("| `{}` | {} |\n", first.operation, cells.join(" | "));
    }
    Ok(text)
}

fn cell(row: &Row) -> String {
    format!(
        "{:.0}, {}, {}",
        row.instructions_mean, row.flash_bytes, row.stack_bytes
    )
}
