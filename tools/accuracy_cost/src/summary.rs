//! The tables at the head of the page: what to choose a type by.

use crate::judged::{Judged, Quantiles};
use crate::row::Row;
use crate::tables::{find, instructions, or_dash, words};
use kit::accuracy::rows;
use std::fmt::{Result, Write};

/// A law with a density per steradian stands for all whose sample needs an azimuth.
const PLANE: &str = "Disk";
const SPACE: &str = "Lambert";

fn of<'a>(rows: &'a [Row], law: &str) -> Vec<&'a Row> {
    rows.iter().filter(|r| r.law == law).collect()
}

fn ulps(error: f64) -> String {
    let digits = if error < 100.0 { 2 } else { 0 };
    format!("{error:.digits$} ulp")
}

fn in_powers_of_two(error: f64) -> String {
    format!("2^{:.1}", error.log2()).replace('-', "−")
}

/// Each type's worst errors over the six laws, and what a direction costs in it.
pub(crate) fn types(out: &mut String, rows: &[Row], judged: &Judged, types: &[String]) -> Result {
    writeln!(
        out,
        "| type | largest error | at | relative | correctly rounded | `{SPACE}` direction: instr. | time | words: plane | space |\n\
         |---|---|---|---|---|---|---|---|---|"
    )?;
    let (plane, space) = (of(rows, PLANE), of(rows, SPACE));
    for name in types {
        let fixed = |e: &&rows::Row| e.tier == *name && !e.law.starts_with("CosPower");
        let errors: Vec<&rows::Row> = judged.errors.iter().filter(fixed).collect();
        let worst = errors.iter().max_by(|a, b| a.max_ulp.total_cmp(&b.max_ulp));
        let relative = errors.iter().map(|e| e.max_relative).fold(0.0, f64::max);
        let tried: u64 = errors.iter().map(|e| e.inputs).sum();
        let missed: u64 = errors.iter().map(|e| e.misrounded).sum();
        let how = if errors.iter().all(|e| e.exhaustive) {
            "exhaustive".to_owned()
        } else {
            let least = errors.iter().map(|e| e.inputs).min().unwrap_or(0);
            format!("observed ({least} inputs or more)")
        };
        let right = match missed {
            0 => format!("all {tried}"),
            // Not to be rounded to all of them.
            _ if missed * 20_000 < tried => format!("all but {missed}"),
            _ => format!("{:.2} %", 100.0 * (1.0 - missed as f64 / tried as f64)),
        };
        let sample = find(&space, name, "sample");
        writeln!(
            out,
            "| `{name}` | {}, {how} | {} | {} | {right} | {} | {} | {} | {} |",
            or_dash(worst, |e| ulps(e.max_ulp)),
            or_dash(worst, |e| format!("{} {}", e.law, e.operation)),
            in_powers_of_two(relative),
            or_dash(sample, instructions),
            or_dash(sample, |r| format!("{:.2}", r.time_to_f32)),
            or_dash(find(&plane, name, "sample"), words),
            or_dash(sample, words)
        )?;
    }
    Ok(())
}

/// Instructions of a direction of each law.
pub(crate) fn directions(
    out: &mut String,
    rows: &[Row],
    laws: &[String],
    types: &[String],
) -> Result {
    writeln!(out, "| law | `{}` |", types.join("` | `"))?;
    writeln!(out, "|---|{}", "---|".repeat(types.len()))?;
    for law in laws {
        let rows = of(rows, law);
        let cells = types
            .iter()
            .map(|name| or_dash(find(&rows, name, "sample"), instructions));
        writeln!(out, "| {law} | {} |", cells.collect::<Vec<_>>().join(" | "))?;
    }
    Ok(())
}

/// How many instructions of `f32` one of `Fast<f32>` replaces.
pub(crate) fn fast(out: &mut String, rows: &[Row], laws: &[String], calls: &[&str]) -> Result {
    let ratio = |law: &str, call: &str| {
        let rows = of(rows, law);
        let plain = find(&rows, "f32", call)?.instructions?;
        Some(plain / find(&rows, "Fast<f32>", call)?.instructions?)
    };
    let cells = laws.iter().flat_map(|l| calls.iter().map(move |c| (l, c)));
    let all: Vec<f64> = cells.filter_map(|(law, call)| ratio(law, call)).collect();
    if all.is_empty() {
        return Ok(());
    }
    let count = |holds: fn(f64) -> bool| all.iter().filter(|x| holds(**x)).count();
    writeln!(
        out,
        "\n## `Fast<f32>` against `f32` on this host\n\n\
         Instructions of `f32` over those of `Fast<f32>`: at least 2 (bold) in {} of {} cells, below 1 in {}, where\n\
         `Fast` works out two ways and selects one, to be without a quotient.\n\n\
         | operation | {} |\n|---|{}",
        count(|x| x >= 2.0),
        all.len(),
        count(|x| x < 1.0),
        laws.join(" | "),
        "---|".repeat(laws.len())
    )?;
    for call in calls {
        let cells = laws.iter().map(|law| {
            or_dash(ratio(law, call), |x| {
                let mark = if x >= 2.0 { "**" } else { "" };
                format!("{mark}{x:.2}{mark}")
            })
        });
        writeln!(
            out,
            "| {call} | {} |",
            cells.collect::<Vec<_>>().join(" | ")
        )?;
    }
    Ok(())
}

/// Quantiles never step back: how many did.
pub(crate) fn quantiles(out: &mut String, all: &[Quantiles]) -> Result {
    let types = distinct(all.iter().map(|q| q.tier.as_str()));
    writeln!(
        out,
        "\n## Monotone quantiles\n\n\
         Neighbours p of \\[0, 1) at which `quantile` or `isf` steps back or, for a planar law, fails to mirror, of all\n\
         that were tried. `Fast` promises none of this.\n\n\
         | law | `{}` |\n|---|{}",
        types.join("` | `"),
        "---|".repeat(types.len())
    )?;
    for law in distinct(all.iter().map(|q| q.law.as_str())) {
        let cells = types.iter().map(|name| {
            let found = all.iter().find(|q| q.law == law && q.tier == *name);
            or_dash(found, |q| {
                let from = q.first_hex.iter().map(|x| format!(" (from {x})"));
                let kind = if q.exhaustive {
                    "exhaustive"
                } else {
                    "observed"
                };
                let from: String = from.collect();
                format!("{}{from}, {kind} ({})", q.steps_back, q.inputs)
            })
        });
        writeln!(out, "| {law} | {} |", cells.collect::<Vec<_>>().join(" | "))?;
    }
    Ok(())
}

fn distinct<'a>(words: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = Vec::new();
    for word in words {
        if !seen.contains(&word) {
            seen.push(word);
        }
    }
    seen
}

/// The worst error at each exponent.
pub(crate) fn exponents(out: &mut String, judged: &Judged, types: &[String]) -> Result {
    writeln!(
        out,
        "\nLargest error of any operation by exponent, in ulps; of `Fast` the relative error.\n\n\
         | exponent | `{}` |\n|---|{}",
        types.join("` | `"),
        "---|".repeat(types.len())
    )?;
    let powers = judged.errors.iter().map(|e| e.law.as_str());
    for law in distinct(powers.filter(|law| law.starts_with("CosPower"))) {
        let cells = types.iter().map(|name| {
            let fast = name.starts_with("Fast<");
            let error = |e: &rows::Row| if fast { e.max_relative } else { e.max_ulp };
            let errors = judged
                .errors
                .iter()
                .filter(|e| e.law == law && e.tier == *name);
            let worst = errors.max_by(|a, b| error(a).total_cmp(&error(b)));
            or_dash(worst, |e| {
                let shown = match fast {
                    true => format!("{:.1e}", e.max_relative),
                    false => format!("{:.2}", e.max_ulp),
                };
                format!("{shown} {}", e.operation)
            })
        });
        let shown = law.trim_start_matches("CosPower(").trim_end_matches(')');
        writeln!(
            out,
            "| {shown} | {} |",
            cells.collect::<Vec<_>>().join(" | ")
        )?;
    }
    Ok(())
}
