//! A panel of relative error against a cost, with the front that nothing beats.

use crate::axis::{Axis, short, superscript};
use crate::canvas::{AMBER, Area, BLUE, Drawn, FAINT, INK, MUTED, RED, TEAL, line, px, text};
use crate::label::{self, Mark, Shape};
use plotters::prelude::*;

pub const PANEL: (f64, f64) = (450.0, 360.0);
/// The plot inside a panel: left, top, right, bottom.
const FRAME: (f64, f64, f64, f64) = (62.0, 36.0, 438.0, 318.0);
/// log₂ of the errors shown; what is beyond stands at the edge.
const ERRORS: (f64, f64) = (-60.0, 9.0);

/// Decades of the cost from which on fewer of them are labelled.
const CROWDED: f64 = 1.8;

/// A contender in a panel.
pub struct Point<'a> {
    pub cost: f64,
    /// Its largest relative error.
    pub error: f64,
    /// Empty where the legend says enough.
    pub short: &'a str,
    pub color: RGBColor,
    pub shape: Shape,
}

impl<'a> Point<'a> {
    /// Ours apart from the peers, coloured by format.
    pub fn of(cost: f64, error: f64, short: &'a str, ours: bool, format: &str) -> Point<'a> {
        Point {
            cost,
            error,
            short,
            color: color(ours, format),
            shape: if ours { Shape::Disk } else { Shape::Dot },
        }
    }
}

fn color(ours: bool, format: &str) -> RGBColor {
    match (ours, format) {
        (true, "f64") => BLUE,
        (true, _) => TEAL,
        (false, "f64") => RED,
        (false, _) => AMBER,
    }
}

/// The words above the panels, with their colours.
pub fn legend(area: &Area, y: f64, notes: &[&str]) -> Drawn {
    let ours = [
        ("● coslobe f32", TEAL),
        ("● coslobe f64", BLUE),
        ("● peers f32", AMBER),
        ("● peers f64", RED),
        ("— front: nothing is both cheaper and more accurate", MUTED),
    ];
    let mut x = 20.0;
    for (word, color) in ours.into_iter().chain(notes.iter().map(|n| (*n, MUTED))) {
        let at = (px(x), px(y));
        area.draw(&Text::new(word.to_owned(), at, text(color, 12.0)))?;
        x += 6.2 * word.chars().count() as f64 + 22.0;
    }
    Ok(())
}

/// `cost` says what it is.
pub fn draw(area: &Area, points: &[Point], cost: &str) -> Drawn {
    let shown: Vec<(&Point, f64, f64)> = points
        .iter()
        .map(|p| {
            let (n, e) = (p.cost.log10(), p.error.log2());
            (p, n, e.clamp(ERRORS.0 + 2.0, 0.0))
        })
        .collect();
    let ends = |f: fn(f64, f64) -> f64, start| shown.iter().map(|p| p.1).fold(start, f);
    let (least, most) = (
        ends(f64::min, f64::INFINITY) - 0.1,
        ends(f64::max, f64::NEG_INFINITY) + 0.1,
    );
    let steps: &[f64] = if most - least > CROWDED {
        &[1.0, 2.0, 5.0]
    } else {
        &[1.0, 1.5, 2.0, 3.0, 5.0, 7.0]
    };
    let ticks: Vec<f64> = (-3..6)
        .flat_map(|e| steps.iter().map(move |m| m * 10f64.powi(e)))
        .map(f64::log10)
        .filter(|n| (least..most).contains(n))
        .collect();
    let x = Axis::new(least..most, ticks, |n| match 10f64.powf(n) {
        cost if cost < 9.5 => short(cost),
        cost => format!("{cost:.0}"),
    });
    let y = Axis::new(
        ERRORS.0..ERRORS.1,
        vec![-53.0, -40.0, -24.0, -12.0, 0.0],
        |e| {
            if e == 0.0 {
                "≥ 1".to_owned()
            } else {
                format!("2{}", superscript(e))
            }
        },
    );
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(FRAME.1))
        .margin_right(px(PANEL.0 - FRAME.2))
        .margin_left(px(8.0))
        .margin_bottom(px(8.0))
        .x_label_area_size(px(PANEL.1 - FRAME.3 - 8.0))
        .y_label_area_size(px(FRAME.0 - 8.0))
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .bold_line_style(line(FAINT, 0.7))
        .light_line_style(TRANSPARENT)
        .axis_style(line(MUTED, 0.9))
        .label_style(text(MUTED, 11.0))
        .axis_desc_style(text(INK, 11.5))
        .set_all_tick_mark_size(px(4.0))
        .x_desc(cost)
        .y_desc("relative error")
        .draw()?;
    let front = front(&shown);
    chart.draw_series([PathElement::new(front.clone(), line(MUTED, 1.2))])?;
    let place = |n: f64, e: f64| {
        let x = FRAME.0 + (n - least) / (most - least) * (FRAME.2 - FRAME.0);
        let y = FRAME.3 - (e - ERRORS.0) / (ERRORS.1 - ERRORS.0) * (FRAME.3 - FRAME.1);
        (x, y)
    };
    let marks: Vec<Mark> = shown
        .iter()
        .map(|&(c, n, e)| {
            let (x, y) = place(n, e);
            Mark {
                x,
                y,
                words: c.short.to_owned(),
                color: c.color,
                shape: c.shape,
            }
        })
        .collect();
    let steps: Vec<(f64, f64)> = front.iter().map(|&(n, e)| place(n, e)).collect();
    label::draw(area, &marks, &steps, FRAME)
}

/// Steps along the points that no other beats in both.
fn front(points: &[(&Point, f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted: Vec<(f64, f64)> = points.iter().map(|p| (p.1, p.2)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut steps: Vec<(f64, f64)> = Vec::new();
    for (n, e) in sorted {
        match steps.last() {
            Some(&(_, best)) if e >= best => {}
            Some(&(_, best)) => steps.extend([(n, best), (n, e)]),
            None => steps.push((n, e)),
        }
    }
    steps
}
