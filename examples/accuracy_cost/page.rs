//! The readable table.

use crate::cell::DRAWS;
use crate::machine::Machine;
use crate::row::Row;
use crate::scipy::Scipy;
use crate::time::ROUNDS;
use std::fmt::Write;

/// Operations in the order of the tables.
const OPERATIONS: [&str; 15] = [
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
];

/// What holds for all figures.
pub(crate) struct About {
    pub(crate) machine: Machine,
    /// Instructions of the generator's `next_u32` and `next_u64`.
    pub(crate) generator: [Option<f64>; 2],
    /// Why there are no instructions.
    pub(crate) skipped: Option<String>,
}

pub(crate) fn markdown(
    rows: &[Row],
    scipy: Option<&Scipy>,
    about: &About,
) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    preface(&mut out, about)?;
    let laws = distinct(rows, |r| &r.law);
    let types = distinct_ours(rows);
    quickest(&mut out, rows, &laws, &types)?;
    if let Some(scipy) = scipy {
        against_scipy(&mut out, scipy)?;
    }
    for law in laws {
        let rows: Vec<&Row> = rows.iter().filter(|r| r.law == law).collect();
        writeln!(out, "\n## {law}\n")?;
        crate::tables::summary(&mut out, &rows, &types, &OPERATIONS)?;
        crate::tables::peers(&mut out, &rows, &types)?;
        crate::tables::details(&mut out, &rows, &OPERATIONS)?;
    }
    Ok(out)
}

fn preface(out: &mut String, about: &About) -> std::fmt::Result {
    let machine = &about.machine;
    let [single, double] = about
        .generator
        .map(|n| n.map_or("–".to_owned(), |n| format!("{n:.0}")));
    writeln!(
        out,
        "# What accuracy costs\n\n\
         Written by `cargo run --release --example accuracy_cost`; do not edit. The same rows are in\n\
         [accuracy_cost.csv](accuracy_cost.csv).\n\n\
         Measured on {}; compiled by {}, {}.\n\n\
         * **ulp**: the largest error seen, in units in the last place of the true value; of `warp` that of\n\
         \x20 the worse of cos θ and sin θ. *Exhaustive*: every number of the format; *observed (n)*: n of them.\n\
         * **instr.**: instructions of a call by callgrind, exact and repeatable on one build: the mean over\n\
         \x20 510 inputs, a third of them by decade, a third even, a third crowding at the ends; less an empty\n\
         \x20 loop. `sample` is the mean of {DRAWS} draws and includes `rand_pcg::Pcg32`, of which a `next_u32` is\n\
         \x20 {single} and a `next_u64` {double}. Peers on `std` run the C library's functions as it chooses them for this processor.\n\
         * **time**: only as a ratio within this run: to the plain type of the same format, or of our types\n\
         \x20 to a peer. The quickest of {ROUNDS} interleaved rounds over even inputs in random order, the loop and\n\
         \x20 the generator included. It is good to some percent, and no more.\n\
         * **words**: calls of the generator for a sample (`u32` + `u64`), mean.\n\
         * **relative error** of a `sample` is that of (cos θ, sin θ), whichever is worse, at the uniforms that the\n\
         \x20 sampler draws itself: 2⁻²⁴ apart (`f64`: 2⁻⁵³) for the peers, down to 2⁻⁶⁵ (2⁻¹²⁹) for ours. Peers\n\
         \x20 that add a point to the normal are judged by their own draws against the exact point of the\n\
         \x20 same uniforms. Of a `quantile` it is that of θ, at every decade of u from either end. *Tail*: p < 10⁻³.\n\
         \x20 1 and more means that nothing of the value is left.",
        machine.target, machine.compiler, machine.flags
    )?;
    if let Some(reason) = &about.skipped {
        writeln!(out, "\nSKIPPED: instructions: {reason}.")?;
    }
    writeln!(
        out,
        "\n![Error against instructions](accuracy_cost.svg)\n\n![Error against u](stability.svg)"
    )
}

/// Our time against the quickest peer's, for every law's directions.
fn quickest(out: &mut String, rows: &[Row], laws: &[String], types: &[String]) -> std::fmt::Result {
    writeln!(
        out,
        "\n## Directions against the quickest peer\n\n\
         Time of `sample` as a multiple of the quickest peer of the same format.\n\n\
         | law | {} |\n|---|{}",
        types.join(" | "),
        "---|".repeat(types.len())
    )?;
    for law in laws {
        write!(out, "| {law} |")?;
        for name in types {
            let samples = || {
                rows.iter()
                    .filter(|r| r.law == *law && r.operation == "sample")
            };
            let ours = samples().find(|r| r.name == *name);
            let peers = samples().filter(|r| !r.ours && Some(&r.format) == ours.map(|o| &o.format));
            let best = peers.min_by(|a, b| a.time_to_plain.total_cmp(&b.time_to_plain));
            match (ours, best) {
                (Some(ours), Some(peer)) => {
                    let ratio = ours.time_to_plain / peer.time_to_plain;
                    write!(out, " {ratio:.2} × {} |", peer.name)?;
                }
                _ => write!(out, " – |")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

fn against_scipy(out: &mut String, scipy: &Scipy) -> std::fmt::Result {
    writeln!(
        out,
        "\n## `Disk.quantile` in f64 against SciPy {}\n\n\
         By `tools/scipy_peer.py`: time an element over {} uniform u, interleaved on one core, and worst relative\n\
         errors from u = ½ down to 10^{}. The ufunc is what runs under `cosine.ppf`'s checks.\n\n\
         | function | time, multiple of ours | θ | cos θ |\n|---|---|---|---|",
        scipy.version,
        scipy.elements,
        scipy
            .errors
            .values()
            .flat_map(|c| c.keys())
            .min()
            .unwrap_or(&0)
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

fn distinct_ours(rows: &[Row]) -> Vec<String> {
    let ours: Vec<Row> = rows.iter().filter(|r| r.ours).cloned().collect();
    distinct(&ours, |r| &r.name)
}
