//! The tables of a law.

use crate::contender::{DIRECTION, SAMPLE};
use crate::row::Row;
use std::fmt::{Result, Write};

/// The row of a call, with the worse of its results.
pub(crate) fn find<'a>(rows: &[&'a Row], name: &str, call: &str) -> Option<&'a Row> {
    let results = rows.iter().filter(|r| r.name == name && r.call() == call);
    let error = |r: &Row| r.max_relative.unwrap_or(0.0);
    let worst = results.max_by(|a, b| {
        a.max_ulp
            .partial_cmp(&b.max_ulp)
            .unwrap_or(std::cmp::Ordering::Equal)
            .then(error(a).total_cmp(&error(b)))
    });
    worst.copied()
}

pub(crate) fn or_dash<T>(value: Option<T>, shown: impl Fn(T) -> String) -> String {
    value.map_or("–".to_owned(), shown)
}

pub(crate) fn instructions(row: &Row) -> String {
    or_dash(row.instructions, |n| format!("{n:.0}"))
}

pub(crate) fn relative(error: Option<f64>) -> String {
    or_dash(error, |e| {
        if e >= 1.0 {
            "≥ 1".to_owned()
        } else if e == 0.0 {
            "0".to_owned()
        } else {
            format!("{e:.1e}")
        }
    })
}

pub(crate) fn words(row: &Row) -> String {
    match (row.next_u32, row.next_u64) {
        (Some(single), Some(double)) => {
            let n = |x: f64| {
                if x.fract() == 0.0 {
                    format!("{x}")
                } else {
                    format!("{x:.1}")
                }
            };
            format!("{} + {}", n(single), n(double))
        }
        _ => "–".to_owned(),
    }
}

/// Ulps, or the relative error of what is not judged in ulps or has but half the bits.
fn error(row: &Row) -> String {
    match row.max_ulp {
        Some(ulps) if kit::promises_ulps(&row.name) => format!("{ulps:.2}"),
        _ => relative(row.max_relative),
    }
}

/// Types side by side: what each operation's digits cost.
pub(crate) fn compact(out: &mut String, rows: &[&Row], types: &[String], calls: &[&str]) -> Result {
    writeln!(out, "| operation | `{}` |", types.join("` | `"))?;
    writeln!(out, "|---|{}", "---|".repeat(types.len()))?;
    for call in calls {
        if rows.iter().all(|r| r.call() != *call) {
            continue;
        }
        write!(out, "| {call} |")?;
        for name in types {
            match find(rows, name, call) {
                Some(row) => write!(
                    out,
                    " {} · {} · {:.2} |",
                    error(row),
                    instructions(row),
                    row.time_to_plain
                )?,
                None => write!(out, " – |")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Peers among our types.
pub(crate) fn peers(out: &mut String, rows: &[&Row], types: &[String]) -> Result {
    if rows.iter().all(|r| r.ours) {
        return Ok(());
    }
    writeln!(
        out,
        "\n| operation | by | relative error | in the tail | instr. | time | words |\n\
         |---|---|---|---|---|---|---|"
    )?;
    for call in [SAMPLE, DIRECTION, "quantile", "pdf", "cdf"] {
        let theirs = rows.iter().filter(|r| !r.ours && r.call() == call);
        let theirs: Vec<&Row> = theirs.copied().collect();
        if theirs.is_empty() {
            continue;
        }
        let ours = types.iter().filter_map(|name| find(rows, name, call));
        for row in ours.chain(theirs) {
            let mark = if row.ours { "**" } else { "" };
            writeln!(
                out,
                "| {call} | {mark}{}{mark} | {} | {} | {} | {:.2} × {} | {} |",
                row.name.replace('<', "\\<"),
                relative(row.max_relative),
                relative(row.max_relative_tail),
                instructions(row),
                row.time_to_plain,
                row.format,
                words(row)
            )?;
        }
    }
    Ok(())
}

/// Every column of every error, folded away.
pub(crate) fn details(out: &mut String, law: &str, rows: &[&Row], calls: &[&str]) -> Result {
    writeln!(
        out,
        "\n<details><summary>{law}: worst inputs, counts of inputs and of misrounded results</summary>\n\n\
         | operation | type | ulp | inputs | worst input | correctly rounded | misrounded | relative error | in the tail |\n\
         |---|---|---|---|---|---|---|---|---|"
    )?;
    for call in calls {
        let ours = || rows.iter().filter(|r| r.ours && r.call() == *call);
        let mut results: Vec<&str> = Vec::new();
        for row in ours() {
            if !results.contains(&row.operation.as_str()) {
                results.push(&row.operation);
            }
        }
        for operation in results {
            for row in ours().filter(|r| r.operation == operation && r.inputs.is_some()) {
                let kind = if row.exhaustive == Some(true) {
                    "exhaustive"
                } else {
                    "observed"
                };
                writeln!(
                    out,
                    "| {operation} | `{}` | {} | {} | {} | {} | {} | {} | {} |",
                    row.name,
                    or_dash(row.max_ulp, |e| format!("{e:.3}")),
                    or_dash(row.inputs, |n| format!("{kind} ({n})")),
                    or_dash(row.worst_input_hex.as_ref(), |s| s.clone()),
                    or_dash(row.correctly_rounded_percent, |p| format!("{p:.2} %")),
                    or_dash(row.misrounded, |n| n.to_string()),
                    relative(row.max_relative),
                    relative(row.max_relative_tail)
                )?;
            }
        }
    }
    writeln!(out, "\n</details>")
}
