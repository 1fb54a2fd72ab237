//! The whole study: measures, then writes all files at once.

use crate::args::Args;
use crate::catalog::Counted;
use crate::contender::Contender;
use crate::count::{Missing, counts};
use crate::error_half;
use crate::errors::Errors;
use crate::inputs::Uniforms;
use crate::machine::Machine;
use crate::row::{Error, Key, Row, csv, read_errors};
use crate::time::times;
use crate::{output, page, pareto, scipy, stability};
use indicatif::{ProgressBar, ProgressStyle};
use std::collections::HashMap;

/// Uniforms in each octave that a relative error is the worst of.
const PER_OCTAVE: u32 = 64;

/// indicatif draws on stderr, and only on a terminal.
pub(crate) fn bar(name: &'static str, total: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:16} {wide_bar} {percent} %, {eta} left");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(total).with_style(style).with_message(name)
}

pub(crate) fn run(args: &Args) -> Result<(), Box<dyn std::error::Error>> {
    output::check(&args.out)?;
    let scipy = scipy::read(&args.out.join("scipy.csv"))?;
    let judged = our_errors(args)?;
    let mut all = Counted::new();

    let calls = all.calls();
    let progress = bar("instructions", calls.len() as u64);
    let counted = counts(&calls, || progress.inc(1));
    progress.finish_and_clear();
    let (counts, skipped) = match counted {
        Ok(counts) => (counts.into_iter().map(Some).collect(), None),
        Err(Missing::Skipped(reason)) => (vec![None; calls.len()], Some(reason)),
        Err(Missing::Failed(e)) => return Err(e.into()),
    };
    let mut list = all.list;
    let (counts, generator) = counts.split_at(list.len());
    let progress = bar("time", list.len() as u64);
    let times = times(&mut list, || progress.inc(1));
    progress.finish_and_clear();

    let progress = bar("relative errors", 2 * list.len() as u64);
    let measured = |from: fn(&Contender) -> Uniforms| -> Vec<Option<Errors>> {
        let each = list.iter().map(|c| {
            progress.inc(1);
            c.measure.as_ref().map(|m| m(from(c), PER_OCTAVE))
        });
        each.collect()
    };
    let own = measured(|c| c.own);
    let everywhere = measured(|_| Uniforms::All);
    progress.finish_and_clear();

    let rows = rows(&list, counts, &times, &own, &judged);
    let mut staging = output::Staging::new(&args.out)?;
    staging.add("accuracy_cost.csv".to_owned(), &csv(&rows)?)?;
    let about = page::About {
        machine: Machine::here(),
        generator: [generator[0], generator[1]],
        skipped: skipped.clone(),
    };
    let text = page::markdown(&rows, scipy.as_ref(), &about)?;
    staging.add("accuracy_cost.md".to_owned(), &text)?;
    match &skipped {
        Some(reason) => eprintln!("SKIPPED: instructions and accuracy_cost.svg: {reason}"),
        None => staging.add("accuracy_cost.svg".to_owned(), &pareto::draw(&list, &rows)?)?,
    }
    let picture = stability::draw(&list, &everywhere, scipy.as_ref())?;
    staging.add("stability.svg".to_owned(), &picture)?;
    staging.publish()?;
    println!("Wrote {}", args.out.join("accuracy_cost.md").display());
    Ok(())
}

/// The errors of our operations: measured, or those of the table that stands.
fn our_errors(args: &Args) -> Result<HashMap<Key, Error>, String> {
    if args.keep_errors {
        return read_errors(&args.out.join("accuracy_cost.csv"));
    }
    let progress = bar("errors", error_half::work(args.stride, args.samples));
    let judged = error_half::measure(args.stride, args.samples, |n| progress.inc(n));
    progress.finish_and_clear();
    let entries = judged.into_iter();
    Ok(entries
        .map(|j| ((j.law, j.operation, j.name), j.error))
        .collect())
}

fn rows(
    list: &[Contender],
    counts: &[Option<f64>],
    times: &[f64],
    own: &[Option<Errors>],
    judged: &HashMap<Key, Error>,
) -> Vec<Row> {
    let plain = |c: &Contender| {
        let same = |p: &&(&Contender, &f64)| {
            p.0.name == c.format && p.0.law == c.law && p.0.operation == c.operation
        };
        let pairs: Vec<_> = list.iter().zip(times).collect();
        pairs.iter().find(same).map_or(f64::NAN, |p| *p.1)
    };
    let measured = list.iter().zip(times).zip(counts).zip(own);
    measured
        .map(|(((c, time), count), own)| {
            let mut row = Row::new(c, *count, time / plain(c));
            if let Some(error) = judged.get(&row.key()).filter(|_| c.ours) {
                row.set(error.clone());
            }
            if let Some(own) = own {
                // Samples and peers have no other judge; a quantile keeps its own worst.
                row.inputs = row.inputs.or(Some(own.inputs));
                row.max_relative = row.max_relative.or(Some(own.worst()));
                row.max_relative_tail = row.max_relative_tail.or(own.worst_in_tail());
            }
            row
        })
        .collect()
}
