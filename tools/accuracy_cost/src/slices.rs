//! The page's tables of slices: what vectors make of a direction.

use crate::contender::{DIRECTION, SAMPLE};
use crate::row::{Row, ours, quickest};
use crate::tables::{find, instructions, or_dash, relative};
use std::fmt::{Result, Write};

/// The call one at a time, and over slices.
const CALLS: [[&str; 2]; 4] = [
    [DIRECTION, "warp_direction_slice"],
    [SAMPLE, "sample_slice"],
    [SAMPLE, "sample_from_bits_slice"],
    ["warp", "warp_slice"],
];

pub(crate) fn section(out: &mut String, rows: &[Row]) -> Result {
    let mut widths: Vec<&str> = Vec::new();
    let mut laws: Vec<&str> = Vec::new();
    let mut types: Vec<&str> = Vec::new();
    for row in rows.iter() {
        let Some(width) = row.vectors else { continue };
        let columns = [
            (&mut widths, width),
            (&mut laws, &row.law),
            (&mut types, &row.name),
        ];
        for (seen, word) in columns {
            if !seen.contains(&word) {
                seen.push(word);
            }
        }
    }
    writeln!(
        out,
        "\n## Slices\n\n\
         A cell is **instructions · time** an element: by callgrind, where it knows the vectors, and as a multiple of the\n\
         quickest peer for the same directions in any format (`warp`: of `f32` one at a time). Slices have 4096\n\
         elements and the bits of the scalar calls, and so their errors. `sample` and `sample_slice` include `Pcg32`, whose\n\
         words come one after the other; `sample_from_bits_slice` takes words that are there."
    )?;
    for [call, slice] in CALLS {
        writeln!(
            out,
            "\n| `{slice}` | type | relative error | {call}, one at a time | {} |\n|---|---|---|---|{}",
            widths.join(" | "),
            "---|".repeat(widths.len())
        )?;
        for law in &laws {
            if ours(rows, [law, slice, "f32"], Some(widths[0])).is_none() {
                continue;
            }
            let peer = quickest(rows, law, call, None);
            let unit = peer.or_else(|| ours(rows, [law, call, "f32"], None));
            let Some(unit) = unit else { continue };
            let cell = |row: Option<&Row>| {
                or_dash(row, |r| {
                    let time = r.time_to_f32 / unit.time_to_f32;
                    format!("{} · {time:.2}", instructions(r))
                })
            };
            let of_law: Vec<&Row> = rows.iter().filter(|r| r.law == **law).collect();
            for name in &types {
                let own = find(&of_law, name, call);
                let error = or_dash(own, |r| relative(r.max_relative));
                let wide = widths
                    .iter()
                    .map(|w| cell(ours(rows, [law, slice, name], Some(w))));
                let wide = wide.collect::<Vec<_>>().join(" | ");
                writeln!(
                    out,
                    "| {law} | `{name}` | {error} | {} | {wide} |",
                    cell(own)
                )?;
            }
            // Peers draw their own words.
            let formats: &[&str] = if slice.contains("bits") {
                &[]
            } else {
                &["f32", "f64"]
            };
            for format in formats {
                if let Some(r) = quickest(rows, law, call, Some(format)) {
                    let (name, error) = (&r.name, relative(r.max_relative));
                    let none = " – |".repeat(widths.len());
                    writeln!(
                        out,
                        "| {law} | {name} | {error} | {} |{none}",
                        cell(Some(r))
                    )?;
                }
            }
        }
    }
    Ok(())
}
