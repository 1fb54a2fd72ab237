//! What every operation costs on every board: instructions, flash, stack, static RAM and random
//! words, beside the errors of the accuracy study and the same thing written by others.

mod builds;
mod check;
mod count;
mod flash;
mod goals;
mod images;
mod integers;
mod linker;
mod measure;
mod page;
mod peers;
mod plots;
mod row;
mod study;

use crate::args::Cost;
use crate::boards::BOARDS;
use crate::failure::{Failure, Result, While};
use crate::report::Report;
use crate::run::bar;
use images::{SUBJECTS, compiler};
use measure::Measured;
use output::{Folder, say};
use rayon::prelude::*;
use study::Study;

/// The files in the folder of the tables.
const CSV: &str = "firmware_cost.csv";
const PAGE: &str = "firmware_cost.md";
/// What `--builds` writes.
const BUILDS: &str = "firmware_builds.md";
const PLOT: &str = "firmware_cost.svg";

/// Measures and writes, or checks what was written.
pub(crate) fn run(options: &Cost, report: &mut Report) -> Result<()> {
    if options.check {
        return check::run(&options.out, report);
    }
    if options.builds {
        let mut folder = Folder::check(&options.out, [BUILDS]).map_err(Failure)?;
        let bar = bar(builds::COUNT);
        folder.add(BUILDS, builds::page(&compiler()?, &bar)?);
        bar.finish_and_clear();
        folder.publish().map_err(Failure)?;
        report.pass("costs of builds written");
        return Ok(());
    }
    let mut folder = Folder::check(&options.out, [CSV, PAGE, PLOT]).map_err(Failure)?;
    let study = Study::read(&options.out.join("accuracy_cost.csv"))?;
    let rustc = compiler()?;
    for board in &BOARDS {
        if let Err(reason) = board.has_target().and_then(|()| board.has_emulator()) {
            // A table without a board would look whole.
            report.skip(&format!("costs, of which nothing is written: {reason}"));
            return Ok(());
        }
    }
    let bar = bar((BOARDS.len() * SUBJECTS.len()) as u64);
    let measured: Vec<Result<Vec<Measured>>> = BOARDS
        .par_iter()
        .map(|board| {
            let each = SUBJECTS.iter().map(|subject| {
                let measured = measure::subject(board, subject, &[], &study, &rustc);
                bar.inc(1);
                measured
            });
            each.collect()
        })
        .collect();
    bar.finish_and_clear();
    let all: Vec<Measured> = measured
        .into_iter()
        .collect::<Result<Vec<_>>>()?
        .into_iter()
        .flatten()
        .collect();
    let rows: Vec<_> = all.iter().flat_map(|m| m.rows.iter().cloned()).collect();
    let goals = goals::all(&rows);
    folder.add(CSV, row::csv(&rows).while_("writing the table")?);
    let page = page::markdown(&all, &rows, &goals, &rustc).while_("writing the page")?;
    folder.add(PAGE, page);
    let plot = plots::draw(&rows).map_err(|e| Failure(format!("drawing: {e}")))?;
    folder.add(PLOT, plot);
    folder.publish().map_err(Failure)?;
    for goal in &goals {
        say(goal.line());
    }
    report.pass(&format!("{} rows of costs written", rows.len()));
    Ok(())
}
