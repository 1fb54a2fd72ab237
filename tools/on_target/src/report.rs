//! What was compared, what failed and what was skipped.

use crate::failure::Result;
use std::process::ExitCode;

/// Counts of outcomes, printed as they come.
#[derive(Default)]
pub(crate) struct Report {
    passed: usize,
    failed: usize,
    skipped: usize,
}

impl Report {
    /// Something was as it should be.
    pub(crate) fn pass(&mut self, what: &str) {
        self.passed += 1;
        println!("ok: {what}");
    }

    /// Something was not.
    pub(crate) fn fail(&mut self, what: &str) {
        self.failed += 1;
        println!("FAILED: {what}");
    }

    /// Passes or fails.
    pub(crate) fn outcome(&mut self, what: &str, outcome: Result<()>) {
        match outcome {
            Ok(()) => self.pass(what),
            Err(e) => self.fail(&format!("{what}: {e}")),
        }
    }

    /// This machine cannot do it.
    pub(crate) fn skip(&mut self, reason: &str) {
        self.skipped += 1;
        println!("SKIPPED: {reason}");
    }

    /// The last lines, and the exit code: skipping is no failure.
    pub(crate) fn finish(mut self, done: Result<()>) -> ExitCode {
        if let Err(e) = done {
            self.fail(&e.to_string());
        }
        let Report {
            passed,
            failed,
            skipped,
        } = self;
        println!("{passed} passed, {failed} failed, {skipped} skipped");
        if failed == 0 {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        }
    }
}
