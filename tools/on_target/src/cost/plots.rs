//! Error against instructions: a column of panels for each board, a row for each law's directions.

use super::images::SUBJECTS;
use super::row::Row;
use crate::boards::BOARDS;
use plot::canvas::{INK, bold, heading, px, svg};
use plot::panel::{self, PANEL, Point};
use plotters::prelude::*;
use std::error::Error;

const TOP: f64 = 64.0;

pub(crate) fn draw(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let mut laws: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|r| r.operation == "sample") {
        if !laws.contains(&row.law.as_str()) {
            laws.push(&row.law);
        }
    }
    let height = TOP + PANEL.1 * laws.len() as f64;
    let size = ((PANEL.0 * BOARDS.len() as f64) as u32, height as u32);
    svg(size, "What accuracy costs on small processors", |area| {
        let title = "Directions: largest relative error of (cos θ, sin θ) against mean instructions (QEMU), generator included";
        area.draw(&Text::new(title, (px(20.0), px(14.0)), bold(INK, 17.0)))?;
        panel::legend(
            area,
            42.0,
            &["Fixed, Fixed16, idsp: in integers, absolute error"],
        )?;
        for (i, law) in laws.iter().enumerate() {
            for (j, board) in BOARDS.iter().enumerate() {
                let corner = (PANEL.0 * j as f64, TOP + PANEL.1 * i as f64);
                let part = area
                    .clone()
                    .shrink((px(corner.0), px(corner.1)), (px(PANEL.0), px(PANEL.1)));
                heading(&part, &format!("{}: {law}", board.name))?;
                let points = rows
                    .iter()
                    .filter(|r| r.operation == "sample" && r.law == *law && r.board == board.name);
                let points = points.filter_map(|r| {
                    let subject = SUBJECTS.iter().find(|s| s.name == r.name)?;
                    let error = r.max_relative.or(r.max_absolute)?;
                    let (cost, format) = (r.instructions_mean, &r.format);
                    Some(Point::of(cost, error, subject.short, r.ours, format))
                });
                let cost = "instructions of a call";
                panel::draw(&part, &points.collect::<Vec<_>>(), cost)?;
            }
        }
        Ok(())
    })
}
