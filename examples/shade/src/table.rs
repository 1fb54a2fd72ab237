//! What each scene costs with the effects that it needs, with all of them, and as written by hand:
//! `shade.csv` and `shade.md`. Built with the feature `std` it writes `shade_std.csv`, which the
//! page quotes.

use indicatif::ProgressBar;
use kit::study::count::{Missing, counts};
use output::{Folder, say};
use shade::cells::{Cell, SHIPPED, cells};
use std::collections::HashMap;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

const CSV: &str = "shade.csv";
const STD: &str = "shade_std.csv";
const PAGE: &str = "shade.md";

/// Rounds over the ways of a scene; the quickest of each counts.
const ROUNDS: usize = 25;

/// One way of one scene.
struct Row<'c> {
    cell: &'c Cell,
    instructions: Option<f64>,
    /// Time of the way `needed` is 1.
    time: f64,
}

pub(crate) fn run(out: &Path) -> Result<(), Box<dyn Error>> {
    let with_std = cfg!(feature = "std");
    let mut folder = Folder::check(out, if with_std { vec![STD] } else { vec![CSV, PAGE] })?;
    let mut cells = cells();
    for c in &cells {
        let needed = cells
            .iter()
            .find(|d| d.scene == c.scene && d.way == "needed");
        if needed.is_none_or(|d| (d.pixels)() != (c.pixels)()) {
            return Err(format!(
                "{}: pixels by `{}` differ; expected the same bits",
                c.scene, c.way
            )
            .into());
        }
    }
    let calls: Vec<u64> = cells.iter().map(|c| c.samples).collect();
    let progress = ProgressBar::new(2 * calls.len() as u64);
    let instructions = match counts(&calls, || progress.inc(1)) {
        Ok(counts) => counts.into_iter().map(Some).collect(),
        Err(Missing::Failed(e)) => return Err(e.into()),
        Err(Missing::Skipped(reason)) => {
            say(format_args!("SKIPPED: instructions: {reason}"));
            vec![None; calls.len()]
        }
    };
    progress.finish_and_clear();
    let times = times(&mut cells);
    let rows: Vec<Row> = cells
        .iter()
        .zip(instructions.iter().zip(&times))
        .map(|(cell, (&instructions, &time))| Row {
            cell,
            instructions,
            time,
        })
        .collect();
    let page = page(&rows, &needed_with_std(&out.join(STD))?);
    if with_std {
        folder.add(STD, csv(&rows)?);
    } else {
        folder.add(CSV, csv(&rows)?);
        folder.add(PAGE, page.clone());
    }
    folder.publish()?;
    say(page);
    Ok(())
}

/// Instructions of the way `needed` by scene, as the command built with `std` has counted them, if
/// it has.
fn needed_with_std(csv: &Path) -> Result<HashMap<String, f64>, Box<dyn Error>> {
    let mut all = HashMap::new();
    if !csv.exists() {
        return Ok(all);
    }
    for row in csv::Reader::from_path(csv)?.records() {
        let row = row?;
        if let (Some(scene), Some("needed"), Some(Ok(n))) =
            (row.get(0), row.get(1), row.get(5).map(str::parse))
        {
            all.insert(scene.to_owned(), n);
        }
    }
    Ok(all)
}

/// Seconds, in interleaved rounds.
fn times(cells: &mut [Cell]) -> Vec<f64> {
    let mut best = vec![f64::INFINITY; cells.len()];
    for _ in 0..ROUNDS {
        for (cell, best) in cells.iter_mut().zip(&mut best) {
            let start = Instant::now();
            (cell.run)();
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    best
}

fn csv(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    csv.write_record([
        "scene",
        "way",
        "effects",
        "rays",
        "words",
        "instructions",
        "time_ratio",
    ])?;
    for row in rows {
        let c = row.cell;
        let base = rows
            .iter()
            .find(|r| r.cell.scene == c.scene && r.cell.way == "needed");
        let ratio = row.time / base.map_or(row.time, |b| b.time);
        csv.write_record([
            c.scene.to_owned(),
            c.way.to_owned(),
            c.effects.map_or(String::new(), |e| e.to_string()),
            c.rays.map_or(String::new(), |n| format!("{n:.3}")),
            c.words.map_or(String::new(), |n| format!("{n:.3}")),
            row.instructions
                .map_or(String::new(), |n| format!("{n:.1}")),
            format!("{ratio:.2}"),
        ])?;
    }
    Ok(String::from_utf8(csv.into_inner()?)?)
}

const HEAD: &str = "\
# What a scene costs

Per sample of a pixel, in `f32`. *Needed*: the effects that the scene calls for, part of the integrator's type
(`Only`). *Asked*: the same effects, one program for all scenes that asks as it goes (`Asked`). *All*: every
effect forced on, those that the scene does not call for with neutral parameters (fog of density 0, a lens of
radius 0, a lamp of no size …). *Hand*: a shader written for that scene alone (`examples/shade/src/hand`). All four
give the same bits, which the command checks before it counts. Rays and words: *needed* → *all*; a camera
without filter and lens traces its ray once a pixel (4 samples here). Instructions are callgrind's, over 16 × 12 pixels spread over the image; times are ratios
within one run, the quickest of 25 interleaved rounds.

*`std`*: needed with coslobe's feature `std`, the square root as an instruction: the same bits.

Regenerated by `cargo run --release -p shade --features std -- table` and then without the feature (Debian: valgrind).

| scene | effects | rays | words | needed, instructions | `std`/needed | hand | needed/hand | asked/needed | all/needed | time: all/needed |
|---|---|---|---|---|---|---|---|---|---|---|
";

fn page(rows: &[Row], with_std: &HashMap<String, f64>) -> String {
    let mut text = HEAD.to_owned();
    for shipped in &SHIPPED {
        let way = |name| {
            rows.iter()
                .find(|r| r.cell.scene == shipped.name && r.cell.way == name)
        };
        let (Some(needed), Some(asked), Some(all)) = (way("needed"), way("asked"), way("all"))
        else {
            continue;
        };
        let hand = way("hand");
        let number = |n: Option<f64>| n.map_or("–".to_owned(), |n| format!("{n:.0}"));
        let ratio =
            |a: &Row, b: Option<&Row>| match (a.instructions, b.and_then(|b| b.instructions)) {
                (Some(a), Some(b)) => format!("{:.2}", a / b),
                _ => "–".to_owned(),
            };
        let both = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => format!("{a:.2} → {b:.2}"),
            _ => "–".to_owned(),
        };
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2} |",
            shipped.name,
            needed.cell.effects.unwrap_or(0),
            both(needed.cell.rays, all.cell.rays),
            both(needed.cell.words, all.cell.words),
            number(needed.instructions),
            match (with_std.get(shipped.name), needed.instructions) {
                (Some(with), Some(without)) => format!("{:.2}", with / without),
                _ => "–".to_owned(),
            },
            number(hand.and_then(|h| h.instructions)),
            ratio(needed, hand),
            ratio(asked, Some(needed)),
            ratio(all, Some(needed)),
            all.time / needed.time,
        );
    }
    text
}
