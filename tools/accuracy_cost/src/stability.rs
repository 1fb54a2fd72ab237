//! The second plot: relative error against log₁₀ u.

use crate::contender::Contender;
use crate::scipy::{OURS, Scipy};
use kit::accuracy::rows::{self, Row};
use kit::study::errors::Errors;
use plot::axis::{Axis, power_of_ten};
use plot::canvas::{
    AMBER, Area, BLUE, Drawn, FAINT, INK, MUTED, RED, TEAL, bold, heading, line, px, svg, text,
};
use plotters::prelude::*;
use std::collections::BTreeMap;
use std::error::Error;

const COLUMNS: usize = 3;
const PANEL: (f64, f64) = (450.0, 362.0);
const TOP: f64 = 66.0;
/// Decades of u shown: all that f32 has; f64 goes on as it stands there.
const DECADES: (f64, f64) = (-38.0, 0.0);
const ERRORS: (f64, f64) = (-17.0, 1.0);
/// Curves after the first of a kind get the next of these.
const OURS_COLORS: [RGBColor; 5] = [
    TEAL,
    BLUE,
    RGBColor(120, 80, 170),
    RGBColor(60, 60, 60),
    RGBColor(90, 150, 60),
];
const PEER_COLORS: [RGBColor; 5] = [
    AMBER,
    RED,
    RGBColor(150, 75, 0),
    RGBColor(200, 60, 150),
    RGBColor(140, 140, 60),
];

struct Curve {
    name: String,
    color: RGBColor,
    points: Vec<(f64, f64)>,
    ours: bool,
}

pub(crate) fn draw(
    list: &[Contender],
    everywhere: &[Option<Errors>],
    judged: &[Row],
    scipy: Option<&Scipy>,
) -> Result<String, Box<dyn Error>> {
    let mut laws: Vec<String> = Vec::new();
    for c in list {
        if !laws.contains(&c.law.to_string()) {
            laws.push(c.law.to_string());
        }
    }
    let rows = laws.len().div_ceil(COLUMNS);
    let size = (
        (PANEL.0 * COLUMNS as f64) as u32,
        (TOP + PANEL.1 * rows as f64) as u32,
    );
    svg(size, "Relative error against the uniform number", |area| {
        let title = "Largest relative error of (cos θ, sin θ) in each decade of p = min(u, 1 − u)";
        area.draw(&Text::new(title, (px(20.0), px(14.0)), bold(INK, 17.0)))?;
        let words = "coslobe, which takes either tail, in bold. Peers take u alone, which nears 1 by 2⁻²⁴ (f64: 2⁻⁵³) at most: further left they are judged near u = 0 only. At 1 nothing of the value is left.";
        area.draw(&Text::new(words, (px(20.0), px(42.0)), text(MUTED, 12.0)))?;
        for (i, law) in laws.iter().enumerate() {
            let left = PANEL.0 * (i % COLUMNS) as f64;
            let top = TOP + PANEL.1 * (i / COLUMNS) as f64;
            let part = area
                .clone()
                .shrink((px(left), px(top)), (px(PANEL.0), px(PANEL.1)));
            heading(&part, law)?;
            panel(&part, &curves(law, list, everywhere, judged, scipy))?;
        }
        Ok(())
    })
}

/// Ours in every type, the peers on the standard library, and SciPy for the disk.
fn curves(
    law: &str,
    list: &[Contender],
    everywhere: &[Option<Errors>],
    judged: &[Row],
    scipy: Option<&Scipy>,
) -> Vec<Curve> {
    let (mut own, mut theirs) = (OURS_COLORS.iter().cycle(), PEER_COLORS.iter().cycle());
    let mut curves = Vec::new();
    for (c, errors) in list.iter().zip(everywhere) {
        if c.law.to_string() != law || c.operation != "sample" {
            continue;
        }
        let points = match errors {
            _ if c.ours => warps(judged, &c.name, &rows::law_name(c.law)),
            Some(errors) if c.name.contains(", std ") => {
                errors.decades.iter().map(|(&d, &e)| point(d, e)).collect()
            }
            _ => continue,
        };
        let color = if c.ours { own.next() } else { theirs.next() };
        curves.push(Curve {
            name: c.short.clone(),
            color: *color.unwrap_or(&INK),
            points,
            ours: c.ours,
        });
    }
    for ((quantity, function), errors) in scipy.iter().flat_map(|s| &s.errors) {
        if law == "Disk" && quantity == "relative_cos" && function != OURS {
            let name = function.rsplit("stats.").next().unwrap_or(function);
            // The ufunc beneath cosine.ppf gives the same values.
            if name.contains("ufuncs") {
                continue;
            }
            curves.push(Curve {
                name: format!("SciPy {name}, cos θ"),
                color: *theirs.next().unwrap_or(&INK),
                points: errors.iter().map(|(&d, &e)| point(d, e)).collect(),
                ours: false,
            });
        }
    }
    curves
}

/// The worse of cos θ and sin θ of both warps, as steps over the decades of p: f64 shares seven.
fn warps(judged: &[Row], name: &str, law: &str) -> Vec<(f64, f64)> {
    let mut worst: BTreeMap<(i32, i32), f64> = BTreeMap::new();
    let warps = judged
        .iter()
        .filter(|r| r.tier == name && r.law == law && r.operation.starts_with("warp"));
    for d in warps.flat_map(|r| &r.decades) {
        let error = worst.entry((d.from, d.to)).or_default();
        *error = error.max(d.max_relative);
    }
    let shown = worst
        .into_iter()
        .filter(|((_, to), _)| f64::from(*to) > DECADES.0);
    let steps = shown.flat_map(|((from, to), error)| {
        let e = error.log10().clamp(ERRORS.0, 0.0);
        [(f64::from(from), e), (f64::from(to), e)]
    });
    // The picture's edge cuts a step.
    let cut = steps.map(|(p, e)| (p.max(DECADES.0), e));
    cut.collect()
}

/// The middle of a decade, and log₁₀ of the error.
fn point(decade: i32, error: f64) -> (f64, f64) {
    let e = error.log10().clamp(ERRORS.0, 0.0);
    (f64::from(decade) + 0.5, e)
}

fn panel(area: &Area, curves: &[Curve]) -> Drawn {
    let x = Axis::new(
        DECADES.0..DECADES.1,
        vec![-35.0, -30.0, -25.0, -20.0, -15.0, -10.0, -5.0, 0.0],
        power_of_ten,
    );
    let y = Axis::new(
        ERRORS.0..ERRORS.1,
        vec![-16.0, -12.0, -8.0, -4.0, 0.0],
        power_of_ten,
    );
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(40.0))
        .margin_right(px(14.0))
        .margin_left(px(8.0))
        .margin_bottom(px(86.0))
        .x_label_area_size(px(38.0))
        .y_label_area_size(px(56.0))
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .bold_line_style(line(FAINT, 0.7))
        .light_line_style(TRANSPARENT)
        .axis_style(line(MUTED, 0.9))
        .label_style(text(MUTED, 11.0))
        .axis_desc_style(text(INK, 11.5))
        .set_all_tick_mark_size(px(4.0))
        .x_desc("p, nearer of u and 1 − u")
        .y_desc("relative error")
        .draw()?;
    for curve in curves.iter().rev() {
        let within = curve.points.iter().filter(|p| p.0 >= DECADES.0);
        let points: Vec<(f64, f64)> = within.copied().collect();
        let width = if curve.ours { 2.2 } else { 1.3 };
        chart.draw_series([PathElement::new(points, line(curve.color, width))])?;
    }
    // Below the plot, two beside each other.
    for (i, curve) in curves.iter().enumerate() {
        let x = 62.0 + 190.0 * (i % 2) as f64;
        let y = 283.0 + 15.0 * (i / 2) as f64;
        let words = format!("— {}", curve.name);
        area.draw(&Text::new(words, (px(x), px(y)), text(curve.color, 11.5)))?;
    }
    Ok(())
}
