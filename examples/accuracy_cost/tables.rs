//! The three tables of a law.

use crate::row::Row;
use std::fmt::{Result, Write};

fn find<'a>(rows: &[&'a Row], name: &str, operation: &str) -> Option<&'a Row> {
    rows.iter()
        .find(|r| r.name == name && r.operation == operation)
        .copied()
}

fn or_dash<T>(value: Option<T>, shown: impl Fn(T) -> String) -> String {
    value.map_or("–".to_owned(), shown)
}

fn instructions(row: &Row) -> String {
    or_dash(row.instructions, |n| format!("{n:.0}"))
}

fn relative(error: Option<f64>) -> String {
    or_dash(error, |e| {
        if e >= 1.0 {
            "≥ 1".to_owned()
        } else {
            format!("{e:.1e}")
        }
    })
}

fn words(row: &Row) -> String {
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

/// Types side by side: what each operation's digits cost.
pub(crate) fn summary(
    out: &mut String,
    rows: &[&Row],
    types: &[String],
    operations: &[&str],
) -> Result {
    write!(out, "| operation |")?;
    for name in types {
        write!(out, " {name}: ulp | instr. | time |")?;
    }
    writeln!(out, "\n|---|{}", "---|".repeat(3 * types.len()))?;
    for operation in operations {
        if rows.iter().all(|r| r.operation != *operation) {
            continue;
        }
        write!(out, "| {operation} |")?;
        for name in types {
            match find(rows, name, operation) {
                Some(row) => write!(
                    out,
                    " {} | {} | {:.2} |",
                    or_dash(row.max_ulp, |e| format!("{e:.3}")),
                    instructions(row),
                    row.time_to_plain
                )?,
                None => write!(out, " – | – | – |")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Peers, with the time of each of our types as a multiple of theirs.
pub(crate) fn peers(out: &mut String, rows: &[&Row], types: &[String]) -> Result {
    let theirs: Vec<&&Row> = rows.iter().filter(|r| !r.ours).collect();
    if theirs.is_empty() {
        return Ok(());
    }
    write!(
        out,
        "\n| operation | peer | relative error | in the tail | instr. | words |"
    )?;
    for name in types {
        write!(out, " {name} takes |")?;
    }
    writeln!(
        out,
        "\n|---|---|---|---|---|---|{}",
        "---|".repeat(types.len())
    )?;
    for operation in ["sample", "quantile", "pdf", "cdf"] {
        // Ours first, as the line to compare with.
        for name in types {
            if let Some(row) = find(rows, name, operation) {
                write!(
                    out,
                    "| {operation} | **{name}** | {} | {} | {} | {} |",
                    relative(row.max_relative),
                    relative(row.max_relative_tail),
                    instructions(row),
                    words(row)
                )?;
                times(out, rows, types, row)?;
            }
        }
        for row in theirs.iter().filter(|r| r.operation == operation) {
            write!(
                out,
                "| {operation} | {} | {} | {} | {} | {} |",
                row.name,
                relative(row.max_relative),
                relative(row.max_relative_tail),
                instructions(row),
                words(row)
            )?;
            times(out, rows, types, row)?;
        }
    }
    Ok(())
}

/// Times of our types as multiples of a row's.
fn times(out: &mut String, rows: &[&Row], types: &[String], row: &Row) -> Result {
    for name in types {
        let ours = find(rows, name, &row.operation);
        // Ratios are to the plain type of a format: only within one do they share a unit.
        let ours = ours.filter(|o| o.format == row.format);
        let ratio = ours.map(|o| o.time_to_plain / row.time_to_plain);
        write!(out, " {} |", or_dash(ratio, |r| format!("{r:.2} ×")))?;
    }
    writeln!(out)
}

/// The worst inputs and what they stand for.
pub(crate) fn details(out: &mut String, rows: &[&Row], operations: &[&str]) -> Result {
    writeln!(
        out,
        "\n| operation | type | ulp | inputs | worst input | correctly rounded | misrounded | relative error | in the tail | instr. | words |\n\
         |---|---|---|---|---|---|---|---|---|---|---|"
    )?;
    for operation in operations {
        for row in rows.iter().filter(|r| r.ours && r.operation == *operation) {
            let kind = if row.exhaustive == Some(true) {
                "exhaustive"
            } else {
                "observed"
            };
            writeln!(
                out,
                "| {operation} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
                row.name,
                or_dash(row.max_ulp, |e| format!("{e:.3}")),
                or_dash(row.inputs, |n| format!("{kind} ({n})")),
                or_dash(row.worst_input.as_ref(), |s| s.clone()),
                or_dash(row.correctly_rounded_percent, |p| format!("{p:.2} %")),
                or_dash(row.misrounded, |n| n.to_string()),
                relative(row.max_relative),
                relative(row.max_relative_tail),
                instructions(row),
                words(row)
            )?;
        }
    }
    Ok(())
}
