//! The whole study: measures, then writes all files at once.

use crate::args::Args;
use crate::catalog::Counted;
use crate::contender::Contender;
use crate::judged::{self, Judged};
use crate::machine::Machine;
use crate::row::{self, csv};
use crate::time::times;
use crate::{fronts, mitsuba, page, pareto, scipy, stability};
use indicatif::{ProgressBar, ProgressStyle};
use kit::accuracy::part::Part;
use kit::accuracy::rows::total_inputs;
use kit::study::count::{Missing, counts};
use kit::study::errors::Errors;
use kit::study::inputs::Uniforms;
use output::{Folder, say, warn};
use std::error::Error;

/// Uniforms in each octave that a relative error is the worst of.
const PER_OCTAVE: u32 = 64;

const JUDGED: &str = judged::FILE;
const TABLE: &str = "accuracy_cost.csv";
const PAGE: &str = "accuracy_cost.md";
const PARETO: &str = "accuracy_cost.svg";
const FRONTS: &str = "accuracy_time.svg";
const STABILITY: &str = "stability.svg";
const FILES: [&str; 6] = [JUDGED, TABLE, PAGE, PARETO, FRONTS, STABILITY];

/// indicatif draws on stderr, and only on a terminal.
pub(crate) fn bar(name: &'static str, total: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:16} {wide_bar} {percent} %, {eta} left");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(total).with_style(style).with_message(name)
}

pub(crate) fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let mut folder = Folder::check(&args.out, FILES)?;
    let scipy = scipy::read(&args.out.join("scipy.csv"))?;
    let mitsuba = mitsuba::read(&args.out)?;
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
    let (counts, generator) = counts.split_at(calls.len() - 2);
    let progress = bar("time", list.len() as u64);
    let times = times(&mut list, || progress.inc(1));
    progress.finish_and_clear();

    let progress = bar("relative errors", 2 * list.len() as u64);
    let measured = |from: fn(&Contender) -> Option<Uniforms>| -> Vec<Option<Errors>> {
        let each = list.iter().map(|c| {
            progress.inc(1);
            let measure = c.measure.as_ref()?;
            Some(measure(from(c)?, PER_OCTAVE))
        });
        each.collect()
    };
    let own = measured(|c| Some(c.own));
    // The stability picture has ours from the judged rows.
    let everywhere = measured(|c| (!c.ours && c.operation == "sample").then_some(Uniforms::All));
    progress.finish_and_clear();

    let mut counts = counts.iter().copied();
    let counts: Vec<Option<f64>> = list
        .iter()
        .map(|c| c.countable().then(|| counts.next().flatten()).flatten())
        .collect();
    let rows = row::rows(&list, &counts, &times, &own, &judged.errors);
    folder.add(JUDGED, judged::to_json(&judged)?);
    folder.add(TABLE, csv(&rows)?);
    let about = page::About {
        machine: Machine::here(),
        generator: [generator[0], generator[1]],
        skipped: skipped.clone(),
        scipy,
        mitsuba,
    };
    let text = page::markdown(&rows, &judged, &about)?;
    folder.add(PAGE, text);
    match &skipped {
        Some(reason) => warn(format_args!("SKIPPED: instructions and {PARETO}: {reason}")),
        None => folder.add(PARETO, pareto::draw(&rows)?),
    }
    folder.add(FRONTS, fronts::draw(&rows)?);
    let scipy = about.scipy.as_ref();
    let picture = stability::draw(&list, &everywhere, &judged.errors, scipy)?;
    folder.add(STABILITY, picture);
    folder.publish()?;
    say(format_args!("Wrote {}", args.out.join(PAGE).display()));
    Ok(())
}

/// The errors of our operations: measured, or those of a file.
fn our_errors(args: &Args) -> Result<Judged, String> {
    let standing = args.out.join(judged::FILE);
    let file = args
        .keep_errors
        .then_some(&standing)
        .or(args.errors.as_ref());
    let (errors, quantiles) = match file {
        Some(path) => judged::read(path)?,
        None => {
            let progress = bar("errors", total_inputs(args.stride, args.samples));
            let errors =
                judged::measure(args.stride, args.samples, Part::WHOLE, |n| progress.inc(n));
            progress.finish_and_clear();
            (errors, None)
        }
    };
    let quantiles = quantiles.unwrap_or_else(|| {
        let progress = bar("quantiles", judged::quantile_keys().len() as u64);
        let quantiles =
            judged::quantiles(args.stride, args.samples, Part::WHOLE, || progress.inc(1));
        progress.finish_and_clear();
        quantiles
    });
    Ok(Judged { errors, quantiles })
}
