//! The figure of one law: lobe, histogram, errors.

use crate::catalog::{Entry, LawName};
use crate::errors;
use crate::lobe;
use crate::measure::{CELLS, Report};
use plot::axis::{Axis, round_down};
use plot::canvas::{
    AMBER, Area, BLUE, Drawn, FAINT, INK, MUTED, TEAL, heading, key, line, px, svg, text,
};
use plotters::prelude::*;
use std::error::Error;

const WIDTH: u32 = 1320;
const HEIGHT: u32 = 340;
const POINTS: u64 = 420;

/// The figure as an SVG file.
pub(crate) fn draw(
    entry: &Entry,
    reports: [&Report; 2],
    seed: u64,
) -> Result<String, Box<dyn Error>> {
    let title = format!("{}: p(θ) = {} {}", entry.title, entry.formula, entry.unit);
    svg((WIDTH, HEIGHT), &title, |area| {
        let (left, rest) = area.split_horizontally(px(430.0));
        let (middle, right) = rest.split_horizontally(px(410.0));
        lobe_panel(&left, entry, seed, &title)?;
        histogram_panel(&middle, entry, reports)?;
        errors::panel(&right, entry, reports)
    })
}

fn lobe_panel(area: &Area, entry: &Entry, seed: u64, title: &str) -> Drawn {
    heading(area, title)?;
    let detail = lobe::Detail {
        points: POINTS,
        point_size: 1.5,
        degrees: true,
    };
    lobe::draw(
        &area.margin(px(40.0), px(62.0), px(16.0), px(16.0)),
        entry,
        seed,
        &detail,
    )?;
    let mut words = vec![("lobe r = p(θ) / p(0)".to_owned(), BLUE)];
    if entry.point.is_some() {
        let seen = match entry.name {
            LawName::Disk => "",
            LawName::CircleShell | LawName::CircleArc => ", thickened outwards",
            _ => ", in projection",
        };
        words.push((format!("{POINTS} points by {}{seen}", entry.measure), AMBER));
        let body = if entry.spatial { "ball" } else { "disk" };
        words.push((format!("tangent {body}, origin at the dot"), INK));
    }
    key(area, (36.0, f64::from(HEIGHT) - 56.0), &words)
}

fn histogram_panel(area: &Area, entry: &Entry, [single, double]: [&Report; 2]) -> Drawn {
    heading(area, "Samples over the density of θ")?;
    let (start, end) = entry.double.shape.window();
    let degrees = |theta: f64| theta.to_degrees();
    let at = |i: f64| start + (end - start) * i / CELLS as f64;
    let density: Vec<(f64, f64)> = (0..=360)
        .map(|i| at(f64::from(i) * CELLS as f64 / 360.0))
        .map(|theta| (degrees(theta), entry.double.probe.marginal(theta)))
        .collect();
    let peak = density.iter().map(|d| d.1).fold(0.0, f64::max);
    let seen = single.histogram.iter().chain(&double.histogram);
    let top = 1.32 * seen.fold(peak, |m, &d| m.max(d));

    let step = match degrees(end) {
        end if end < 89.0 => round_down(end / 3.0),
        _ if start < 0.0 => 30.0,
        _ => 15.0,
    };
    let x = Axis::stepped(degrees(start)..degrees(end), step);
    let y = Axis::stepped(0.0..top, round_down(top / 3.0));
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(40.0))
        .margin_right(px(20.0))
        .margin_bottom(px(8.0))
        .margin_left(px(6.0))
        .x_label_area_size(px(40.0))
        .y_label_area_size(px(58.0))
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .bold_line_style(line(FAINT, 0.7))
        .light_line_style(TRANSPARENT)
        .axis_style(line(MUTED, 0.9))
        .label_style(text(MUTED, 11.0))
        .axis_desc_style(text(INK, 12.0))
        .set_all_tick_mark_size(px(4.0))
        .x_desc("θ from the axis, degrees")
        .y_desc("density of θ, rad⁻¹")
        .draw()?;
    chart.draw_series(double.histogram.iter().enumerate().map(|(i, &d)| {
        let corners = [
            (degrees(at(i as f64)), 0.0),
            (degrees(at(i as f64 + 0.92)), d),
        ];
        Rectangle::new(corners, BLUE.mix(0.28).filled())
    }))?;
    chart.draw_series([PathElement::new(density, line(BLUE, 1.8))])?;
    chart.draw_series(single.histogram.iter().enumerate().map(|(i, &d)| {
        let middle = (degrees(at(i as f64 + 0.46)), d);
        Circle::new(middle, px(1.9) as u32, TEAL.filled())
    }))?;
    let p = |r: &Report| {
        r.chi_squared_p
            .map_or("–".to_owned(), |p| format!("{p:.3}"))
    };
    let words = [
        (format!("bars: f64, χ² p = {}", p(double)), BLUE),
        (format!("dots: f32, χ² p = {}", p(single)), TEAL),
    ];
    key(area, (78.0, 44.0), &words)
}
