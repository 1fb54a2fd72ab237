//! The readable tables.

use super::goals::{Goal, SAMPLES};
use super::images::SUBJECTS;
use super::measure::Measured;
use super::row::Row;
use crate::boards::BOARDS;
use std::fmt::{Result, Write};

pub(crate) fn markdown(
    all: &[Measured],
    rows: &[Row],
    goals: &[Goal],
    rustc: &str,
) -> std::result::Result<String, std::fmt::Error> {
    let mut out = String::new();
    head(&mut out, rows, rustc)?;
    reached(&mut out, goals)?;
    for board in &BOARDS {
        writeln!(
            out,
            "\n## {}: `{}`, QEMU's `{}`\n",
            board.name, board.target, board.machine
        )?;
        for (operation, generator) in SAMPLES {
            writeln!(
                out,
                "\nMean instructions of a direction, `{generator}`'s included:\n"
            )?;
            by_law(&mut out, rows, |law, name| {
                let key = [board.name, law, operation, name];
                rows.iter().find(|r| r.key() == key).map(mean)
            })?;
        }
        writeln!(
            out,
            "\nBytes of flash that a direction links, the generator's included:\n"
        )?;
        by_law(&mut out, rows, |law, name| {
            direction(rows, board.name, law, name).map(|r| r.flash_bytes.to_string())
        })?;
        writeln!(
            out,
            "\nBytes of flash of a law with every one of its operations:\n"
        )?;
        by_law(&mut out, rows, |law, name| {
            let whole = all.iter().flat_map(|m| &m.whole_laws);
            let mut own = whole.filter(|w| w.0 == board.name && w.1 == law && w.2 == name);
            own.next().map(|w| w.3.to_string())
        })?;
        writeln!(out, "\nBytes of stack of a direction:\n")?;
        by_law(&mut out, rows, |law, name| {
            direction(rows, board.name, law, name).map(|r| r.stack_bytes.to_string())
        })?;
        for law in laws(rows) {
            operations(&mut out, rows, board.name, law)?;
        }
    }
    Ok(out)
}

fn head(out: &mut String, rows: &[Row], rustc: &str) -> Result {
    writeln!(
        out,
        "# What it costs on small processors\n\n\
         Written by `cargo run --release -p on_target -- cost`; do not edit. The same rows for a machine, joined to the\n\
         errors of the [accuracy study](accuracy_cost.md), are in `docs/measured/firmware_cost.csv`; error against instructions, with\n\
         the front that nothing beats, is in `docs/measured/firmware_cost.svg`.\n\n\
         Compiled by {rustc} with opt-level 3, fat LTO and one codegen unit. Instructions, not cycles.\n\
         [What overflow checks and levels for size change](firmware_builds.md) is measured apart.\n\n\
         * *Instructions* of one call through a pointer, less those of a call that only returns its argument or constants:\n\
         \x20 exact under QEMU's `-icount shift=0`, by SysTick over 256 calls of one input on Cortex-M (whose quotient has to\n\
         \x20 be a whole number) and by `minstret` on RISC-V. Least, mean and most are over 16 fixed inputs, from both ends of\n\
         \x20 the domain through subnormal tails to the middle, or over 24 draws.\n\
         * *Flash*: code and constants that can be reached from the operation, its soft-float and other routines of the\n\
         \x20 compiler included, as `--gc-sections` keeps them; vectors and start-up not.\n\
         * *Stack*: by painting it; the deepest of all inputs, the function's own frame included.\n\
         * *Static RAM* is 0 in every row of ours, and no panic can be reached: the run fails otherwise.\n\
         * Samplers draw from `rand_pcg::Pcg32`, as in the accuracy study, and (`sample_xorshift`) from\n\
         \x20 `rand_xorshift::XorShiftRng`, which needs no 64-bit product: no generator for an M0 has one. A generator's own cost is\n\
         \x20 in the table below and in every direction. *Words* are of 32 bits, and the same for every draw."
    )?;
    writeln!(
        out,
        "* `textbook`: the polar form and the laws' formulas in `libm`'s or `micromath`'s functions, uniforms on the grid of\n\
         \x20 2⁻²⁴; `idsp and integer roots`: `idsp::cossin` and 16-bit square roots. SKIPPED: CMSIS-DSP: Debian has no package\n\
         \x20 of it.\n\n\
         | generator | call | {} |\n|---|---|{}",
        BOARDS.map(|b| b.name).join(" | "),
        "---|".repeat(BOARDS.len())
    )?;
    let of_generators = rows.iter().filter(|r| r.operation.starts_with("next_u"));
    for first in of_generators.filter(|r| r.board == BOARDS[0].name) {
        let cells = BOARDS.iter().map(|board| {
            let key = [board.name, &first.law, &first.operation, &first.name];
            let own = rows.iter().find(|r| r.key() == key);
            own.map_or("–".to_owned(), mean)
        });
        let cells: Vec<String> = cells.collect();
        writeln!(
            out,
            "| {} | {} | {} |",
            first.law,
            first.operation,
            cells.join(" | ")
        )?;
    }
    Ok(())
}

fn reached(out: &mut String, goals: &[Goal]) -> Result {
    writeln!(
        out,
        "\n## Goals\n\n| what | wanted | found | |\n|---|---|---|---|"
    )?;
    for goal in goals {
        let found = goal.found.as_ref().map_or("–", |f| &f.0);
        writeln!(
            out,
            "| {} | {} | {found} | {} |",
            goal.what,
            goal.wanted,
            goal.verdict()
        )?;
    }
    Ok(())
}

fn direction<'a>(rows: &'a [Row], board: &str, law: &str, name: &str) -> Option<&'a Row> {
    rows.iter()
        .find(|r| r.key() == [board, law, "sample", name])
}

fn mean(row: &Row) -> String {
    format!("{:.0}", row.instructions_mean)
}

/// The laws, in the order of the rows.
fn laws(rows: &[Row]) -> Vec<&str> {
    let mut seen: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|r| r.operation == "sample") {
        if !seen.contains(&row.law.as_str()) {
            seen.push(&row.law);
        }
    }
    seen
}

/// Laws down, types and peers across.
fn by_law(out: &mut String, rows: &[Row], cell: impl Fn(&str, &str) -> Option<String>) -> Result {
    let drawing = |name: &str| {
        rows.iter()
            .any(|r| r.name == name && r.operation == "sample")
    };
    let subjects: Vec<_> = SUBJECTS.iter().filter(|s| drawing(s.name)).collect();
    let names = subjects.iter().map(|s| match s.ours {
        true => format!("`{}`", s.name),
        false => s.name.to_owned(),
    });
    writeln!(out, "| law | {} |", names.collect::<Vec<_>>().join(" | "))?;
    writeln!(out, "|---|{}", "---|".repeat(subjects.len()))?;
    for law in laws(rows) {
        let cells = subjects
            .iter()
            .map(|s| cell(law, s.name).unwrap_or("–".to_owned()));
        writeln!(out, "| {law} | {} |", cells.collect::<Vec<_>>().join(" | "))?;
    }
    Ok(())
}

/// Every operation of a law, folded away.
fn operations(out: &mut String, rows: &[Row], board: &str, law: &str) -> Result {
    let own: Vec<&Row> = rows
        .iter()
        .filter(|r| r.board == board && r.law == law)
        .collect();
    let mut calls: Vec<&str> = Vec::new();
    for row in &own {
        if !calls.contains(&row.operation.as_str()) {
            calls.push(&row.operation);
        }
    }
    writeln!(
        out,
        "\n<details><summary>{law}: every operation</summary>\n\n\
         | operation | by | instructions: least | mean | most | flash | stack | words | error: ulp | relative | absolute |\n\
         |---|---|---|---|---|---|---|---|---|---|---|"
    )?;
    let or_dash = |value: Option<String>| value.unwrap_or("–".to_owned());
    for call in calls {
        for row in own.iter().filter(|r| r.operation == call) {
            writeln!(
                out,
                "| {call} | {} | {} | {:.0} | {} | {} | {} | {} | {} | {} | {} |",
                row.name.replace('<', "\\<"),
                row.instructions_least,
                row.instructions_mean,
                row.instructions_most,
                row.flash_bytes,
                row.stack_bytes,
                row.words,
                or_dash(row.max_ulp.map(|e| format!("{e:.2}"))),
                or_dash(row.max_relative.map(|e| match e {
                    e if e >= 1.0 => "≥ 1".to_owned(),
                    e => format!("{e:.1e}"),
                })),
                or_dash(row.max_absolute.map(|e| format!("{e:.1e}"))),
            )?;
        }
    }
    writeln!(out, "\n</details>")
}
