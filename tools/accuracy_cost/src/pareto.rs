//! The first plot: relative error against instructions, with the front that nothing beats.

use crate::row::Row;
use plot::canvas::{INK, bold, heading, px, svg};
use plot::panel::{self, PANEL, Point};
use plotters::prelude::*;
use std::error::Error;

const COLUMNS: usize = 3;
const TOP: f64 = 64.0;
pub(crate) fn draw(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let mut panels: Vec<(String, &str)> = Vec::new();
    for operation in ["sample", "quantile"] {
        for row in rows.iter().filter(|r| r.operation == operation) {
            let panel = (row.law.clone(), operation);
            if !panels.contains(&panel) {
                panels.push(panel);
            }
        }
    }
    let height = TOP + PANEL.1 * panels.len().div_ceil(COLUMNS) as f64;
    let size = ((PANEL.0 * COLUMNS as f64) as u32, height as u32);
    svg(size, "What accuracy costs in instructions", |area| {
        let title = "Largest relative error of one call against its instructions (callgrind)";
        area.draw(&Text::new(title, (px(20.0), px(14.0)), bold(INK, 17.0)))?;
        let notes = [
            "sample: generator included, error of (cos θ, sin θ)",
            "quantile: error of θ",
        ];
        panel::legend(area, 42.0, &notes)?;
        for (i, (law, operation)) in panels.iter().enumerate() {
            let corner = (i % COLUMNS, i / COLUMNS);
            let left = PANEL.0 * corner.0 as f64;
            let top = TOP + PANEL.1 * corner.1 as f64;
            let part = area
                .clone()
                .shrink((px(left), px(top)), (px(PANEL.0), px(PANEL.1)));
            heading(&part, &format!("{law}: {operation}"))?;
            let points = rows
                .iter()
                .filter(|r| r.law == *law && r.operation == *operation);
            let points = points.filter_map(|r| {
                let (cost, error) = (r.instructions?, r.max_relative?);
                Some(Point::of(cost, error, &r.short, r.ours, &r.format))
            });
            panel::draw(&part, &points.collect::<Vec<_>>(), "instructions of a call")?;
        }
        Ok(())
    })
}
