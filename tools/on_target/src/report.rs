//! What was compared, what failed and what was skipped.

use crate::failure::Result;
use output::say;
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
        say(format_args!("ok: {what}"));
    }

    /// Something was not.
    pub(crate) fn fail(&mut self, what: &str) {
        self.failed += 1;
        say(format_args!("FAILED: {what}"));
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
        say(format_args!("SKIPPED: {reason}"));
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
        say(format_args!(
            "{passed} passed, {failed} failed, {skipped} skipped"
        ));
        let done = match failed {
            0 => Ok(()),
            _ => Err(format!("{failed} failed")),
        };
        output::exit_code("on_target", done)
    }
}
