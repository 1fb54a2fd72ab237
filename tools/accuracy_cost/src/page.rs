//! The readable table.

use crate::contender::{DIRECTION, PARTS, SAMPLE, plain};
use crate::judged::Judged;
use crate::machine::Machine;
use crate::mitsuba::Mitsuba;
use crate::row::{self, Row};
use crate::scipy::Scipy;
use crate::tables::or_dash;
use crate::time::ROUNDS;
use crate::{limits, slices, summary};
use kit::promises_ulps;
use kit::study::cell::DRAWS;
use std::fmt::Write;

/// Operations in the order of the tables.
const OPERATIONS: [&str; 16] = [
    "pdf",
    "ln_pdf",
    "pdf_solid_angle",
    "cdf",
    "sf",
    "density",
    "lambert_weight",
    "unwarp",
    "unwarp_sf",
    "warp",
    "warp_sf",
    "quantile",
    "isf",
    "sample",
    "sample_around",
    DIRECTION,
];

/// What holds for all figures.
pub(crate) struct About {
    pub(crate) machine: Machine,
    /// Instructions of the generator's `next_u32` and `next_u64`.
    pub(crate) generator: [Option<f64>; 2],
    /// Why there are no instructions.
    pub(crate) skipped: Option<String>,
    pub(crate) scipy: Option<Scipy>,
    pub(crate) mitsuba: Option<Mitsuba>,
}

pub(crate) fn markdown(
    rows: &[Row],
    judged: &Judged,
    about: &About,
) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    let laws = distinct(rows, |r| &r.law);
    let types = distinct_ours(rows);
    head(&mut out, about)?;
    summary::types(&mut out, rows, judged, &types)?;
    writeln!(out, "\n## Instructions of a direction\n")?;
    summary::directions(&mut out, rows, &laws, &types)?;
    summary::fast(&mut out, rows, &laws, &OPERATIONS)?;
    quickest(&mut out, rows, &laws, &types)?;
    slices::section(&mut out, rows)?;
    limits::section(&mut out, rows, about.mitsuba.as_ref())?;
    if let Some(scipy) = &about.scipy {
        against_scipy(&mut out, scipy)?;
    }
    summary::quantiles(&mut out, &judged.quantiles)?;
    how(&mut out, about)?;
    for law in laws {
        let rows: Vec<&Row> = rows.iter().filter(|r| r.law == law).collect();
        writeln!(out, "\n## {law}\n")?;
        crate::tables::compact(&mut out, &rows, &types, &OPERATIONS)?;
        crate::tables::peers(&mut out, &rows, &types)?;
        crate::tables::details(&mut out, &law, &rows, &OPERATIONS)?;
        if law.starts_with("CosPower") {
            summary::exponents(&mut out, judged, &types)?;
        }
    }
    Ok(out)
}

fn head(out: &mut String, about: &About) -> std::fmt::Result {
    let machine = &about.machine;
    writeln!(
        out,
        "# What accuracy costs\n\n\
         Written by `cargo run --release -p accuracy_cost`; do not edit. The same rows for a machine are in\n\
         `docs/measured/accuracy_cost.csv`, the errors at full length in `docs/measured/accuracy_errors.json`, the pictures in\n\
         `docs/measured/accuracy_cost.svg` (error against instructions), `docs/measured/accuracy_time.svg` (error against time) and\n\
         `docs/measured/stability.svg` (error against u).\n\n\
         Instructions and times on {}; compiled by {}, {}; counted by {}.\n\n\
         ## The number types\n\n\
         Errors: of any operation of the six fixed laws, anywhere in its domain; *relative* is the largest of\n\
         |error| over the true value (or the least normal number, where that is larger). *Time* is a multiple of `f32`'s\n\
         in the same run. *Words*: calls of `next_u32` + `next_u64` for a direction.\n",
        machine.target, machine.compiler, machine.flags, machine.valgrind
    )?;
    if let Some(reason) = &about.skipped {
        writeln!(out, "SKIPPED: instructions: {reason}.\n")?;
    }
    Ok(())
}

fn how(out: &mut String, about: &About) -> std::fmt::Result {
    let [single, double] = about
        .generator
        .map(|n| n.map_or("–".to_owned(), |n| format!("{n:.0}")));
    let mut text = include_str!("how_to_read.md").to_owned();
    for (word, value) in [
        ("{next_u32}", single),
        ("{next_u64}", double),
        ("{draws}", DRAWS.to_string()),
        ("{rounds}", ROUNDS.to_string()),
    ] {
        text = text.replace(word, &value);
    }
    write!(out, "\n{text}")
}

/// Our time against the quickest peer's, for every law's directions.
fn quickest(out: &mut String, rows: &[Row], laws: &[String], types: &[String]) -> std::fmt::Result {
    writeln!(
        out,
        "\n## Directions against the quickest peer\n\n\
         Time of `sample` as a multiple of that of the quickest peer of the same format. *Words and azimuth*: what a\n\
         direct sampler in space spends before any law, one at a time, in the plain type and the coarse one; slices go\n\
         below it."
    )?;
    for format in ["f32", "f64"] {
        let types: Vec<&String> = types.iter().filter(|name| plain(name) == format).collect();
        write!(out, "\n| law | quickest peer |")?;
        types
            .iter()
            .try_for_each(|name| write!(out, " `{name}` |"))?;
        writeln!(
            out,
            " words and azimuth |\n|---|---|{}---|",
            "---|".repeat(types.len())
        )?;
        for law in laws {
            let samples = rows
                .iter()
                .filter(|r| r.law == *law && r.operation == SAMPLE && r.format == format && r.ours);
            let Some(peer) = row::quickest(rows, law, SAMPLE, Some(format)) else {
                continue;
            };
            write!(out, "| {law} | {} |", peer.name)?;
            for row in samples {
                write!(out, " {:.2} |", row.time_to_plain / peer.time_to_plain)?;
            }
            let parts = rows.iter().filter(|r| {
                let shown = r.name == format || !promises_ulps(&r.name);
                r.law == *law && r.operation == PARTS && r.format == format && shown
            });
            let share = |r: &Row| format!("{:.2}", r.time_to_plain / peer.time_to_plain);
            let shares = parts.map(share).collect::<Vec<_>>();
            let shares = Some(shares.join(", ")).filter(|s| !s.is_empty());
            writeln!(out, " {} |", or_dash(shares, |s| s))?;
        }
    }
    Ok(())
}

fn against_scipy(out: &mut String, scipy: &Scipy) -> std::fmt::Result {
    let decades = scipy.errors.values().flat_map(|c| c.keys());
    let least = *decades.min().unwrap_or(&0);
    writeln!(
        out,
        "\n## `Disk.quantile` in f64 against SciPy {}\n\n\
         By `tools/scipy_peer.py`: time an element over {} uniform u, interleaved on one core, and worst relative\n\
         errors from u = ½ down to {}. The ufunc is what runs under `cosine.ppf`'s checks.\n\n\
         | function | time, multiple of ours | θ | cos θ |\n|---|---|---|---|",
        scipy.version,
        scipy.elements,
        plot::axis::power_of_ten(f64::from(least))
    )?;
    let worst = |quantity: &str, function: &str| {
        let key = (quantity.to_owned(), function.to_owned());
        let curve = scipy.errors.get(&key);
        let worst = curve.and_then(|c| c.values().copied().reduce(f64::max));
        worst.map_or("–".to_owned(), |e| format!("{e:.2e}"))
    };
    let ours = (crate::scipy::OURS.to_owned(), 1.0);
    for (function, time) in std::iter::once(&ours).chain(&scipy.time) {
        writeln!(
            out,
            "| {function} | {time:.2} | {} | {} |",
            worst("relative_theta", function),
            worst("relative_cos", function)
        )?;
    }
    Ok(())
}

fn distinct(rows: &[Row], key: impl Fn(&Row) -> &String) -> Vec<String> {
    let mut seen = Vec::new();
    for row in rows {
        if !seen.contains(key(row)) {
            seen.push(key(row).clone());
        }
    }
    seen
}

pub(crate) fn distinct_ours(rows: &[Row]) -> Vec<String> {
    let ours: Vec<Row> = rows.iter().filter(|r| r.ours).cloned().collect();
    distinct(&ours, |r| &r.name)
}
