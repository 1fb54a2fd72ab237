//! Every law in every number type, on every board.

use crate::boards::{BOARDS, Board};
use crate::build::Build;
use crate::difference::same;
use crate::failure::{Failure, Result, While};
use crate::qemu::{self, Emulation};
use crate::report::Report;
use crate::types::{TYPES, laws};
use crate::{host, start};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use std::time::Duration;

const EMULATION: Emulation = Emulation {
    counts: false,
    timeout: Duration::from_secs(60),
};

/// Builds and runs all of them.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    let images = TYPES.map(|number| laws(number).len());
    let bar = bar((BOARDS.len() * images.iter().sum::<usize>()) as u64);
    // Each board's images are built one after the other: they share their dependencies.
    let outcomes: Vec<_> = BOARDS
        .par_iter()
        .map(|board| (board, board_outcomes(board, &bar)))
        .collect();
    bar.finish_and_clear();
    for (board, outcomes) in outcomes {
        match outcomes {
            Ok(outcomes) => {
                let number = outcomes.len();
                let failures: Vec<_> = outcomes.into_iter().filter_map(Result::err).collect();
                for failure in &failures {
                    report.fail(&failure.to_string());
                }
                if failures.is_empty() {
                    report.pass(&format!(
                        "{}: {number} images draw what the host draws",
                        board.name
                    ));
                }
            }
            Err(reason) => report.skip(&format!("firmware on {reason}")),
        }
    }
    start::run(report)
}

/// The outcome of each image, or why none can be run.
fn board_outcomes(board: &Board, bar: &ProgressBar) -> Result<Vec<Result<()>>> {
    board.has_target()?;
    board.has_emulator()?;
    let images = TYPES
        .iter()
        .flat_map(|number| laws(number).into_iter().map(move |law| (law, *number)));
    Ok(images
        .map(|(law, number)| {
            let outcome = image(board, law, number);
            bar.inc(1);
            outcome.while_(format!("{}: {law} in {number}", board.name))
        })
        .collect())
}

fn image(board: &Board, law: &str, number: &str) -> Result<()> {
    let build = Build {
        board,
        package: "law",
        variables: vec![
            ("COSLOBE_LAW", law.to_owned()),
            ("COSLOBE_TYPE", number.to_owned()),
        ],
        features: &[],
        debug: false,
    };
    let output = qemu::run(board, &build.image()?, &[], EMULATION)?;
    same(&host::law(law, number)?, &String::from_utf8_lossy(&output)).map_err(Failure)
}

/// A bar that shows itself on terminals only.
pub(crate) fn bar(length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} ({eta})");
    ProgressBar::new(length).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
