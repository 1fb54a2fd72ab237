//! Hashes of samples and evaluations: this machine and every board against the committed ones.

mod ask;
mod bisect;
mod expected;

use crate::args::Hashes;
use crate::boards::{BOARDS, Board};
use crate::difference::first;
use crate::failure::{Failure, Result, While};
use crate::report::Report;
use crate::run::bar;
use crate::types::{TYPES, laws};
use ask::{Asked, Device, Host};
use expected::Expected;
use indicatif::ProgressBar;
use kit::Stream;
use output::say;
use rayon::prelude::*;
use std::time::Instant;

/// What every run compares, and takes seconds: samples, inputs.
const SHORT: [u32; 2] = [4096, 1024];

/// Up to which count a stream is compared.
fn last(options: &Hashes, stream: Stream) -> u32 {
    let short = match stream {
        Stream::Samples => SHORT[0],
        Stream::Values => SHORT[1],
    };
    match options.last {
        Some(last) => last,
        None if options.full || options.bless => stream.length(),
        None => short,
    }
}

/// Compares, or writes what is expected.
pub(crate) fn run(options: &Hashes, report: &mut Report) -> Result<()> {
    let wanted = |name: &str| options.only.is_empty() || options.only.iter().any(|o| o == name);
    if let Some(unknown) = options.only.iter().find(|o| !known(o)) {
        let names = BOARDS.map(|b| b.name).join(", ");
        return Err(Failure(format!(
            "no board {unknown}; expected host, {names}"
        )));
    }
    if let Some(unknown) = options.types.iter().find(|t| !TYPES.contains(&&***t)) {
        let names = TYPES.join(", ");
        return Err(Failure(format!("no type {unknown}; expected {names}")));
    }
    if options.bless {
        return expected::write(|number, stream| {
            Host { number }.ask(&[
                "all",
                stream.name(),
                "checkpoints",
                &stream.length().to_string(),
            ])
        });
    }
    let expected = Expected::read()?;
    let laws_of_all = types(options).map(|number| laws(number).len());
    let jobs = (laws_of_all.sum::<usize>() * Stream::ALL.len()) as u64;
    if wanted("host") {
        let start = Instant::now();
        for number in types(options) {
            let outcome = compare(options, number, &Host { number }, &expected, &bar(jobs));
            report.outcome(&format!("host: hashes of {number}"), outcome);
        }
        say(format_args!("host: {:.0} s", start.elapsed().as_secs_f64()));
    }
    let boards: Vec<&Board> = BOARDS.iter().filter(|b| wanted(b.name)).collect();
    let bar = bar(jobs * boards.len() as u64);
    let outcomes: Vec<_> = boards
        .par_iter()
        .map(|board| (board.name, on_board(options, board, &expected, &bar)))
        .collect();
    bar.finish_and_clear();
    for (name, outcomes) in outcomes {
        match outcomes {
            Ok(outcomes) => {
                for (number, outcome) in outcomes {
                    report.outcome(&format!("{name}: hashes of {number}"), outcome);
                }
            }
            Err(reason) => report.skip(&format!("hashes on {reason}")),
        }
    }
    Ok(())
}

/// The number types that are asked for.
fn types(options: &Hashes) -> impl Iterator<Item = &'static str> {
    let wanted = |t: &&str| options.types.is_empty() || options.types.iter().any(|o| o == t);
    TYPES.into_iter().filter(wanted)
}

fn known(name: &str) -> bool {
    name == "host" || BOARDS.iter().any(|b| b.name == name)
}

/// Each number type's outcome, or why the board cannot be used.
#[allow(clippy::type_complexity)] // a name and an outcome
fn on_board(
    options: &Hashes,
    board: &Board,
    expected: &Expected,
    bar: &ProgressBar,
) -> Result<Vec<(&'static str, Result<()>)>> {
    board.has_target()?;
    board.has_emulator()?;
    let one = |number| {
        let start = Instant::now();
        let device = Device::build(board, number, options)?;
        let outcome = compare(options, number, &device, expected, bar);
        let seconds = start.elapsed().as_secs_f64();
        // At once: a full run takes hours.
        let said = if outcome.is_ok() {
            "equal"
        } else {
            "different"
        };
        let name = board.name;
        bar.suspend(|| {
            say(format_args!(
                "{name}: {number}: {said} after {seconds:.0} s"
            ))
        });
        outcome
    };
    Ok(types(options).map(|number| (number, one(number))).collect())
}

/// Every law's streams in one number type.
fn compare(
    options: &Hashes,
    number: &str,
    asked: &impl Asked,
    expected: &Expected,
    bar: &ProgressBar,
) -> Result<()> {
    for law in laws(number) {
        for stream in Stream::ALL {
            let last = last(options, stream);
            let found = asked.ask(&[law, stream.name(), "checkpoints", &last.to_string()])?;
            let expected = expected.lines(law, number, stream, last)?;
            if let Some((expected, found)) = first(&expected, &found) {
                let cause = bisect::cause(&Host { number }, asked, law, stream, expected)
                    .while_("looking for the first result that differs")?;
                return Err(Failure(format!(
                    "expected {expected}\n   found {found}\n{cause}"
                )));
            }
            bar.inc(1);
        }
    }
    Ok(())
}
