//! A short run: cells that are measured twice are equal, and equal to the committed ones with the
//! same compiler; the linker keeps as many bytes as were counted.

use super::images::{SUBJECTS, Subject, compiler};
use super::row::{Row, read};
use super::{CSV, linker, measure, study::Study};
use crate::boards::{BOARDS, Board};
use crate::failure::{Failure, Result};
use crate::report::Report;
use rayon::prelude::*;
use std::path::Path;

/// Binary, law and operation: of three binaries, since building them takes most of the time.
const CELLS: [[&str; 3]; 7] = [
    ["f32", "Lambert", "sample"],
    ["f32", "Disk", "quantile"],
    ["f32", "Ball", "cdf"],
    ["fixed", "Lambert", "sample_xorshift"],
    ["fixed", "Disk", "cdf"],
    ["fixed16", "Lambert", "sample_xorshift"],
    ["libm", "Lambert", "sample"],
];

pub(crate) fn run(folder: &Path, report: &mut Report) -> Result<()> {
    let committed = read(&folder.join(CSV))?;
    let rustc = compiler()?;
    let recorded = committed.first().map_or("", |r| r.rustc.as_str());
    let same_compiler = recorded == rustc;
    if !same_compiler {
        report.skip(&format!(
            "costs against the table: it is of {recorded}, this is {rustc}"
        ));
    }
    let boards: Vec<(&Board, Result<Vec<String>>)> = BOARDS
        .par_iter()
        .map(|board| {
            let usable = board.has_target().and_then(|()| board.has_emulator());
            let differing = usable.map(|()| {
                let cells = CELLS
                    .iter()
                    .map(|cell| one(board, *cell, &rustc, same_compiler.then_some(&committed)));
                let faults = cells.filter_map(|r| r.err().map(|e| e.to_string()));
                faults.collect()
            });
            (board, differing)
        })
        .collect();
    for (board, outcome) in boards {
        match outcome {
            Err(reason) => report.skip(&format!("costs on {reason}")),
            Ok(faults) if faults.is_empty() => {
                let against = if same_compiler {
                    ", and as committed"
                } else {
                    ""
                };
                report.pass(&format!("{}: costs, the same twice{against}", board.name));
            }
            Ok(faults) => faults.iter().for_each(|f| report.fail(f)),
        }
    }
    Ok(())
}

fn one(
    board: &Board,
    [binary, law, operation]: [&str; 3],
    rustc: &str,
    committed: Option<&Vec<Row>>,
) -> Result<()> {
    let subject: &Subject = SUBJECTS
        .iter()
        .find(|s| s.binary == binary)
        .ok_or_else(|| Failure(format!("no binary {binary}")))?;
    let study = Study::default();
    let measured = || measure::subject(board, subject, &[law, operation], &study, rustc);
    let (first, second) = (measured()?, measured()?);
    linker::agrees(&first.image, &first.sections[0], first.rows[0].flash_bytes)?;
    let (first, second) = (&first.rows[0], &second.rows[0]);
    same(first, second, "measured again").map_err(Failure)?;
    let Some(committed) = committed else {
        return Ok(());
    };
    let known = committed.iter().find(|r| r.key() == first.key());
    let known =
        known.ok_or_else(|| Failure(format!("{}: no row in {CSV}", first.key().join(" "))))?;
    same(known, first, "against the table").map_err(Failure)
}

/// Whether two measurements of a cell agree.
fn same(expected: &Row, found: &Row, how: &str) -> std::result::Result<(), String> {
    if expected.measured() == found.measured() {
        return Ok(());
    }
    Err(format!(
        "{}, {how}: instructions least, mean, most, flash, stack, RAM, words are {:?}; expected {:?}",
        found.key().join(" "),
        found.measured(),
        expected.measured()
    ))
}
