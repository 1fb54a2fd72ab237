//! Whether the study can be trusted: counts repeat, and each sampler, ours or a peer's, follows its
//! law.

use crate::catalog::Counted;
use crate::study::bar;
use kit::study::count::{Missing, counts};
use output::say;
use std::error::Error;

/// Standard errors that a mean may be off: among a hundred samplers, one in a million runs.
const SIGMAS: f64 = 6.0;

pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let mut all = Counted::new();
    let calls = all.calls();
    let list = &all.list;
    let mut wrong = Vec::new();
    for c in list {
        // `sample_around` has another axis.
        let mean = c.cell.mean_cos.filter(|_| c.operation == "sample");
        let Some(mean) = mean else {
            continue;
        };
        let (want, deviation) = c.expected_cos();
        let off = (mean - want).abs() / (deviation / (c.cell.calls as f64).sqrt());
        if off > SIGMAS {
            let law = c.law.to_string();
            wrong.push(format!(
                "{law}, {}: mean cos θ is {mean:.4}; expected {want:.4} ({off:.1} standard errors)",
                c.name
            ));
        }
    }
    let progress = bar("instructions", 2 * calls.len() as u64);
    let both = counts(&calls, || progress.inc(1))
        .and_then(|first| Ok((first, counts(&calls, || progress.inc(1))?)));
    progress.finish_and_clear();
    match both {
        Ok((first, second)) => {
            let counted = list.iter().filter(|c| c.countable());
            for (c, (a, b)) in counted.zip(first.iter().zip(&second)) {
                if a != b {
                    let law = c.law.to_string();
                    wrong.push(format!(
                        "{law}, {}, {}: {a} instructions, then {b}; expected the same",
                        c.operation, c.name
                    ));
                }
            }
            say(format_args!("{} counts, twice", first.len()));
        }
        Err(Missing::Skipped(reason)) => say(format_args!("SKIPPED: instructions: {reason}")),
        Err(Missing::Failed(e)) => wrong.push(e),
    }
    if wrong.is_empty() {
        Ok(())
    } else {
        Err(wrong.join("; ").into())
    }
}
