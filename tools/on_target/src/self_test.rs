//! The power-on check on every board: passes with a good generator, and names every planted fault.

use crate::boards::{BOARDS, Board, succeeds};
use crate::build::{Build, workspace};
use crate::failure::{Failure, Result, While};
use crate::report::Report;
use kit::self_test as cases;
use rayon::prelude::*;
use std::path::Path;
use std::process::Command;

/// Builds it once a board and runs every case.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    if !succeeds("defmt-print", &["--version"]) {
        report.skip("self-test: defmt-print is not installed (cargo install defmt-print --locked)");
        return Ok(());
    }
    let outcomes: Vec<_> = BOARDS
        .par_iter()
        .map(|board| (board, outcomes(board)))
        .collect();
    for (board, outcomes) in outcomes {
        match outcomes {
            Ok(outcomes) => {
                for (case, outcome) in outcomes {
                    let what = format!("{}: self-test, {case}", board.name);
                    match outcome {
                        Ok(line) => report.pass(&format!("{what}: {line}")),
                        Err(e) => report.fail(&format!("{what}: {e}")),
                    }
                }
            }
            Err(reason) => report.skip(&format!("self-test on {reason}")),
        }
    }
    Ok(())
}

/// The outcome of each case, or why none can be run.
fn outcomes(board: &Board) -> Result<Vec<(&'static str, Result<String>)>> {
    board.has_target()?;
    board.has_emulator()?;
    let image = Build {
        board,
        package: "self_test",
        variables: vec![],
        features: &[],
        debug: false,
    }
    .image()?;
    Ok(cases::NAMES
        .map(|case| (case, one(board, &image, case)))
        .into())
}

/// The verdict in short, if it is the one that this machine comes to: every count is the same.
fn one(board: &Board, image: &Path, case: &str) -> Result<String> {
    let verdict = cases::verdict(case).ok_or_else(|| Failure(format!("no case {case}")))?;
    let output = Command::new(workspace().join("run"))
        .args([board.machine.as_ref(), image.as_os_str(), case.as_ref()])
        .output()
        .while_("starting the runner")?;
    let text = String::from_utf8_lossy(&output.stdout);
    let (expected, short) = match verdict {
        Ok(report) => (format!("passed: {report:?}"), "passed".to_owned()),
        Err(fault) => (format!("failed: {fault:?}"), fault.to_string()),
    };
    if !text.lines().any(|line| line == expected) {
        let errors = String::from_utf8_lossy(&output.stderr);
        return Err(Failure(format!(
            "expected {expected}\nfound {text}{errors}"
        )));
    }
    if output.status.success() != verdict.is_ok() {
        return Err(Failure(format!("exit {}", output.status)));
    }
    if case == "cost" {
        return documented(board, &text);
    }
    Ok(short)
}

/// What the image says of its cost, in the order of the table.
const COSTS: [&str; 3] = [
    "instructions a sample: ",
    "bytes of stack: ",
    "bytes of stack in integers: ",
];

/// The costs, if the table in docs/measured/self_test.md has them to a tenth: they move with the
/// compiler.
fn documented(board: &Board, text: &str) -> Result<String> {
    let page = include_str!("../../../docs/measured/self_test.md");
    let row = format!("| {} | ", board.name);
    let cells = page.lines().find_map(|line| line.strip_prefix(&row));
    let cells = cells
        .unwrap_or_default()
        .trim_end_matches(" |")
        .split(" | ");
    let mut found = Vec::new();
    for (cost, committed) in COSTS.into_iter().zip(cells.chain(["", "", ""])) {
        let own = text.lines().find_map(|line| line.strip_prefix(cost));
        let own = own.unwrap_or_default();
        let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
        if (number(own) / number(committed) - 1.0).abs() <= 0.1 {
            found.push(format!("{cost}{own}"));
        } else {
            return Err(Failure(format!(
                "{cost}{own}, docs/measured/self_test.md says {committed:?}"
            )));
        }
    }
    Ok(format!("{}, as documented", found.join(", ")))
}
