//! Proofs of release images, by what is linked into them; each beside a planted violation that it
//! catches.

mod elf;
mod image;
mod laws;
mod overflow;
pub(crate) mod scenes;
mod sources;
mod symbols;
mod thumb;
mod whole;

use crate::boards::{BOARDS, Board};
use crate::failure::{Failure, Result};
use crate::report::Report;
use crate::run::bar;
use indicatif::ProgressBar;
use rayon::prelude::*;

/// What was shown, and whether it holds.
type Shown = Vec<(String, Result<()>)>;

/// Shows all of it on every target that is there.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    let bar = bar(BOARDS.iter().map(images).sum());
    let shown: Vec<_> = BOARDS
        .par_iter()
        .map(|board| (board.name, on_board(board, &bar)))
        .collect();
    bar.finish_and_clear();
    for (name, shown) in shown {
        match shown {
            Ok(shown) => {
                for (what, outcome) in shown {
                    report.outcome(&format!("{name}: {what}"), outcome);
                }
            }
            Err(reason) => report.skip(&format!("proofs at link time on {reason}")),
        }
    }
    Ok(())
}

fn images(board: &Board) -> u64 {
    whole::IMAGES + laws::images(board) + overflow::images(board)
}

fn on_board(board: &Board, bar: &ProgressBar) -> Result<Shown> {
    board.has_target()?;
    let mut shown = whole::show(board, bar);
    shown.extend(laws::show(board, bar));
    shown.extend(overflow::show(board, bar));
    Ok(shown)
}

/// An outcome turned around: a planted violation has to be caught, and for its own reason.
pub(crate) fn caught(outcome: Result<()>, reason: &str) -> Result<()> {
    match outcome {
        Ok(()) => Err(Failure("the planted violation was not caught".to_owned())),
        Err(e) if e.to_string().contains(reason) => Ok(()),
        Err(e) => Err(Failure(format!(
            "failed, but not for the planted violation ({reason}): {e}"
        ))),
    }
}

/// Fails with a reason unless something holds.
fn ensure(holds: bool, reason: impl FnOnce() -> String) -> Result<()> {
    if holds {
        Ok(())
    } else {
        Err(Failure(reason()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_planted_violation_counts_as_caught() {
        let failed = || Err(Failure("undefined symbol: a_panic_is_reachable".to_owned()));
        assert!(caught(failed(), "a_panic_is_reachable").is_ok());
        assert!(caught(failed(), "static RAM").is_err());
        assert!(caught(Ok(()), "static RAM").is_err());
    }
}
