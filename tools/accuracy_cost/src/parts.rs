//! The errors in parts, each by itself on any machine, and the parts merged to what one run writes.

use crate::args::{Args, MergeArgs};
use crate::judged::{self, Judged, Quantiles};
use crate::study::bar;
use kit::accuracy::part::Part;
use kit::accuracy::rows::{Row, total_inputs};
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::fs;
use std::path::Path;

#[derive(Deserialize, Serialize)]
struct Share {
    part: u64,
    of: u64,
    stride: u64,
    samples: u64,
    errors: Vec<Row>,
    quantiles: Vec<Quantiles>,
}

/// Whole or not at all: a job that was killed is run again.
fn write(path: &Path, text: &str) -> Result<(), String> {
    let draft = path.with_extension(format!("draft{}", std::process::id()));
    let done = fs::write(&draft, text).and_then(|()| fs::rename(&draft, path));
    done.map_err(|e| format!("{}: {e}", path.display()))
}

/// Measures one part into its file in the folder.
pub(crate) fn one(args: &Args, part: Part) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(&args.out)?;
    let Args {
        stride, samples, ..
    } = *args;
    let progress = bar("errors", total_inputs(stride, samples) / part.of);
    let errors = judged::measure(stride, samples, part, |n| progress.inc(n));
    progress.finish_and_clear();
    let share = Share {
        part: part.index,
        of: part.of,
        stride,
        samples,
        errors,
        quantiles: judged::quantiles(stride, samples, part, || ()),
    };
    let name = format!("part-{}-of-{}.json", part.index, part.of);
    write(&args.out.join(name), &serde_json::to_string(&share)?)?;
    Ok(())
}

/// All parts of one run as its `accuracy_errors.json`.
pub(crate) fn merge(args: &MergeArgs) -> Result<(), Box<dyn Error>> {
    let mut shares = Vec::new();
    for path in &args.parts {
        let explain = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
        let text = fs::read_to_string(path).map_err(|e| explain(&e))?;
        shares.push(serde_json::from_str::<Share>(&text).map_err(|e| explain(&e))?);
    }
    shares.sort_by_key(|s| s.part);
    let run = |s: &Share| (s.of, s.stride, s.samples);
    let complete = shares.first().is_some_and(|first| {
        shares.len() as u64 == first.of
            && shares.iter().all(|s| run(s) == run(first))
            && shares.iter().zip(1..).all(|(s, i)| s.part == i)
    });
    if !complete {
        let of: Vec<_> = shares
            .iter()
            .map(|s| format!("{}/{}", s.part, s.of))
            .collect();
        let of = of.join(" ");
        return Err(format!("expected every part of one run once; given {of}").into());
    }
    let whole = shares.into_iter().reduce(|a, b| Share {
        errors: pairs(a.errors, b.errors, Row::merge),
        quantiles: pairs(a.quantiles, b.quantiles, Quantiles::merge),
        ..a
    });
    let whole = whole.ok_or("no part given")?;
    let judged = Judged {
        errors: whole.errors,
        quantiles: whole.quantiles,
    };
    write(&args.out, &judged::to_json(&judged)?)?;
    Ok(())
}

fn pairs<T>(a: Vec<T>, b: Vec<T>, merge: fn(T, T) -> T) -> Vec<T> {
    a.into_iter().zip(b).map(|(a, b)| merge(a, b)).collect()
}
