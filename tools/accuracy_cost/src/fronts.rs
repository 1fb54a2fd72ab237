//! The third plot: relative error against time, with the front that nothing beats.

use crate::contender::{DIRECTION, SAMPLE};
use crate::page::distinct_ours;
use crate::row::{Row, quickest};
use kit::promises_ulps;
use plot::canvas::{Area, Drawn, INK, MUTED, bold, heading, px, svg, text};
use plot::label::{Shape, shape};
use plot::panel::{self, PANEL, Point};
use plotters::prelude::*;
use std::error::Error;

const COLUMNS: usize = 3;
const TOP: f64 = 84.0;
/// An operation one at a time and over slices, in the words of a panel.
const OPERATIONS: [[&str; 3]; 2] = [
    [DIRECTION, "warp_direction_slice", "given uniforms"],
    [SAMPLE, "sample_slice", "drawn"],
];
/// Okabe and Ito's, told apart by colour-blind eyes too: the plain types', then those of the
/// others.
const COLORS: [RGBColor; 5] = [
    RGBColor(0, 114, 178),
    RGBColor(0, 0, 0),
    RGBColor(86, 180, 233),
    RGBColor(110, 110, 110),
    RGBColor(204, 121, 167),
];
const PEER: RGBColor = RGBColor(213, 94, 0);
const SHAPES: [(&str, Shape); 5] = [
    ("one at a time", Shape::Disk),
    ("slices: SSE2", Shape::Triangle),
    ("AVX2", Shape::Square),
    ("AVX-512", Shape::Diamond),
    ("peers", Shape::Cross),
];

/// The types, each with its colour: those that promise ulps first.
fn colored(rows: &[Row]) -> Vec<(String, RGBColor)> {
    let mut types = distinct_ours(rows);
    types.sort_by_key(|name| !promises_ulps(name));
    types.into_iter().zip(COLORS).collect()
}

fn point<'r>(row: &'r Row, unit: f64, types: &[(String, RGBColor)]) -> Option<Point<'r>> {
    let cost = row.time_to_f32 / unit;
    let (color, shape, short) = if row.ours {
        let color = types.iter().find(|(name, _)| *name == row.name)?.1;
        let shape = match row.vectors {
            None => Shape::Disk,
            Some("AVX2") => Shape::Square,
            Some("AVX-512") => Shape::Diamond,
            Some(_) => Shape::Triangle,
        };
        (color, shape, "")
    } else {
        // The quickest, and what a host's author writes.
        let labelled = cost == 1.0 || ["libm", "micromath"].iter().all(|l| !row.name.contains(l));
        (PEER, Shape::Cross, if labelled { &*row.short } else { "" })
    };
    Some(Point {
        cost,
        error: row.max_relative?,
        short,
        color,
        shape,
    })
}

pub(crate) fn draw(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let types = colored(rows);
    let mut panels = Vec::new();
    for operation in OPERATIONS {
        for row in rows
            .iter()
            .filter(|r| r.ours && r.operation == operation[0])
        {
            let panel = (&*row.law, operation);
            if !panels.contains(&panel) {
                panels.push(panel);
            }
        }
    }
    let height = TOP + PANEL.1 * panels.len().div_ceil(COLUMNS) as f64;
    let size = ((PANEL.0 * COLUMNS as f64) as u32, height as u32);
    svg(size, "What accuracy costs in time", |area| {
        let title = "Directions: largest relative error of (cos θ, sin θ) against time, a multiple of the quickest peer's";
        area.draw(&Text::new(title, (px(20.0), px(14.0)), bold(INK, 17.0)))?;
        legend(area, &types)?;
        for (i, (law, [scalar, slices, words])) in panels.iter().enumerate() {
            let left = PANEL.0 * (i % COLUMNS) as f64;
            let top = TOP + PANEL.1 * (i / COLUMNS) as f64;
            let part = area
                .clone()
                .shrink((px(left), px(top)), (px(PANEL.0), px(PANEL.1)));
            heading(&part, &format!("{law}: {words}"))?;
            let Some(peer) = quickest(rows, law, scalar, None) else {
                continue;
            };
            let of_panel = |r: &&Row| r.law == *law && [*scalar, *slices].contains(&&*r.operation);
            let points = rows.iter().filter(of_panel);
            let points: Vec<Point> = points
                .filter_map(|r| point(r, peer.time_to_f32, &types))
                .collect();
            panel::draw(&part, &points, "time: 1 is the quickest peer")?;
        }
        Ok(())
    })
}

fn legend(area: &Area, types: &[(String, RGBColor)]) -> Drawn {
    let mut x = 26.0;
    let mut put = |y: f64, mark: Shape, words: &str, color: RGBColor| -> Drawn {
        shape(area, mark, (x, y + 7.0), color)?;
        let at = (px(x + 9.0), px(y));
        area.draw(&Text::new(words.to_owned(), at, text(color, 12.0)))?;
        x += 6.6 * words.chars().count() as f64 + 34.0;
        Ok(())
    };
    for (name, color) in types {
        put(42.0, Shape::Disk, name, *color)?;
    }
    for (words, mark) in SHAPES {
        put(
            42.0,
            mark,
            words,
            if mark == Shape::Cross { PEER } else { MUTED },
        )?;
    }
    let words = "Same type, same bits: vectors move a point to the left alone. — front: nothing is both quicker and more accurate. Drawn: the generator included, whose words come one after the other.";
    area.draw(&Text::new(words, (px(20.0), px(64.0)), text(MUTED, 12.0)))?;
    Ok(())
}
