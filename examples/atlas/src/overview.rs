//! All lobes in one picture, for the README.

use crate::catalog::Entry;
use crate::lobe;
use plot::canvas::{AMBER, Area, BLUE, Drawn, INK, MUTED, bold, centred, px, svg, text};
use plotters::prelude::*;
use std::error::Error;

const CELL: (f64, f64) = (250.0, 206.0);

/// The overview as an SVG file: laws of the plane above, laws of space below.
pub(crate) fn draw(entries: &[&Entry], seed: u64) -> Result<String, Box<dyn Error>> {
    let planar: Vec<&Entry> = entries.iter().copied().filter(|e| !e.spatial).collect();
    let spatial: Vec<&Entry> = entries.iter().copied().filter(|e| e.spatial).collect();
    let rows: Vec<Vec<&Entry>> = [planar, spatial]
        .into_iter()
        .filter(|r| !r.is_empty())
        .collect();
    let height = 8.0 + CELL.1 * rows.len() as f64;
    svg((1000, height as u32), "The lobes of coslobe", |area| {
        for (i, row) in rows.iter().enumerate() {
            let top = 4.0 + CELL.1 * i as f64;
            for (j, entry) in row.iter().enumerate() {
                cell(&part(area, j, top), entry, seed)?;
            }
            if row.len() < 4 && i == 0 {
                legend(&part(area, row.len(), top))?;
            }
        }
        Ok(())
    })
}

fn part<'a>(area: &Area<'a>, column: usize, top: f64) -> Area<'a> {
    let left = CELL.0 * column as f64;
    area.clone()
        .shrink((px(left), px(top)), (px(CELL.0), px(CELL.1)))
}

fn cell(area: &Area, entry: &Entry, seed: u64) -> Drawn {
    let middle = px(CELL.0 / 2.0);
    let title = entry.title.to_owned();
    area.draw(&Text::new(
        title,
        (middle, px(20.0)),
        centred(bold(INK, 15.0)),
    ))?;
    let formula = format!("{} {}", entry.formula, entry.unit);
    area.draw(&Text::new(
        formula,
        (middle, px(40.0)),
        centred(text(BLUE, 12.5)),
    ))?;
    let detail = lobe::Detail {
        points: 180,
        point_size: 1.1,
        degrees: false,
    };
    lobe::draw(
        &area.margin(px(58.0), px(26.0), px(4.0), px(4.0)),
        entry,
        seed,
        &detail,
    )?;
    let measure = entry.measure.to_owned();
    area.draw(&Text::new(
        measure,
        (middle, px(CELL.1 - 14.0)),
        centred(text(MUTED, 11.5)),
    ))?;
    Ok(())
}

fn legend(area: &Area) -> Drawn {
    let lines = [
        ("Lobe r = p(θ) / p(0)", BLUE),
        ("Disk or ball that touches the origin", INK),
        ("Points drawn by the law’s measure", AMBER),
        ("on the circle: of a thin shell", AMBER),
        ("Space (sr⁻¹): side view", MUTED),
    ];
    for (i, (words, color)) in lines.into_iter().enumerate() {
        let y = 64.0 + 20.0 * i as f64;
        area.draw(&Text::new(words, (px(14.0), px(y)), text(color, 12.0)))?;
    }
    Ok(())
}
