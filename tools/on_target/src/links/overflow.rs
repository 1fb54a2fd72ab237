//! Images of every operation with overflow checks on, at the levels that small flash calls for: no
//! panic there either, whatever the optimiser leaves of the checks.

use super::image::build_as;
use super::whole::{CALLS, LITTLE, complete};
use super::{Shown, caught};
use crate::boards::Board;
use crate::failure::Result;
use indicatif::ProgressBar;

const LEVELS: [&str; 2] = ["s", "z"];

/// Processors with the least instructions and with the most; other Thumb cores lie between them.
fn shown_on(board: &Board) -> bool {
    ["M0", "M4F"].contains(&board.name)
}

/// Images that [`show`] builds.
pub(super) fn images(board: &Board) -> u64 {
    if shown_on(board) {
        (LEVELS.len() * (CALLS.len() + 1)) as u64
    } else {
        0
    }
}

pub(super) fn show(board: &Board, bar: &ProgressBar) -> Shown {
    if !shown_on(board) {
        return Shown::new();
    }
    let mut shown = Vec::new();
    for level in LEVELS {
        let how = format!("opt-level {level}, overflow checks on");
        for (types, calls) in CALLS {
            let outcome = with_checks(board, calls, level, None);
            bar.inc(1);
            shown.push((format!("{types}, {how}: no panic"), outcome));
        }
        let planted = with_checks(board, LITTLE, level, Some("plant-overflow"));
        bar.inc(1);
        let reason = "undefined symbol: a_panic_is_reachable";
        shown.push((
            format!("{how}: plant-overflow is caught"),
            caught(planted, reason),
        ));
    }
    shown
}

fn with_checks(board: &Board, calls: &str, level: &str, planted: Option<&str>) -> Result<()> {
    let settings = vec![
        ("CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS", "true".to_owned()),
        ("CARGO_PROFILE_RELEASE_OPT_LEVEL", level.to_owned()),
    ];
    let (_, image) = build_as(board, calls, planted, settings)?;
    complete(&image)
}
