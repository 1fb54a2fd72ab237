//! The plot of the tail: the crate's errors beside the hand-rolled ones.

use crate::catalog::Entry;
use crate::measure::Report;
use crate::sweep::stretch;
use plot::axis::{Axis, power_of_ten};
use plot::canvas::{
    AMBER, Area, BLUE, Drawn, FAINT, INK, MUTED, RED, TEAL, centred, heading, key, line, px, text,
};
use plotters::prelude::*;

/// Errors below and above are drawn at the edge.
const ERRORS: (f64, f64) = (-18.0, 1.0);

pub(crate) fn panel(area: &Area, entry: &Entry, reports: [&Report; 2]) -> Drawn {
    heading(area, "Relative error of cos θ towards the horizon")?;
    let (near, far) = (stretch(0.5f64.log10()), stretch(-300.0));
    let decades = [
        0.5f64.log10(),
        -1.0,
        -2.0,
        -5.0,
        -10.0,
        -20.0,
        -38.0,
        -100.0,
        -300.0,
    ];
    let x = Axis::new(near..far, decades.map(stretch).to_vec(), tail_label);
    let y = Axis::new(
        ERRORS.0..ERRORS.1,
        vec![-16.0, -12.0, -8.0, -4.0, 0.0],
        power_of_ten,
    );
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(40.0))
        .margin_right(px(24.0))
        .margin_bottom(px(8.0))
        .margin_left(px(6.0))
        .x_label_area_size(px(40.0))
        .y_label_area_size(px(60.0))
        .build_cartesian_2d(x, y)?;
    let tail = if entry.spatial {
        "P(Θ > θ)"
    } else {
        "P(Θ < −|θ|)"
    };
    chart
        .configure_mesh()
        .bold_line_style(line(FAINT, 0.7))
        .light_line_style(TRANSPARENT)
        .axis_style(line(MUTED, 0.9))
        .label_style(text(MUTED, 11.0))
        .axis_desc_style(text(INK, 12.0))
        .set_all_tick_mark_size(px(4.0))
        .x_desc(format!("tail probability p = {tail}"))
        .y_desc("relative error, worst of a bin")
        .draw()?;
    let curves = reports.into_iter().zip([(TEAL, AMBER), (BLUE, RED)]);
    for (report, (ours, theirs)) in curves {
        chart.draw_series([PathElement::new(
            curve(&report.sweep.hand_rolled_error),
            line(theirs, 1.3),
        )])?;
        chart.draw_series([PathElement::new(
            curve(&report.sweep.crate_error),
            line(ours, 2.2),
        )])?;
        let sweep = &report.sweep;
        let style = centred(text(ours, 11.5));
        let words = format!("coslobe {}, ≤ {:.2} ulp", report.format, sweep.worst_ulp);
        let least = sweep.crate_error.iter().map(|e| e.1);
        let least = least.skip(20).fold(f64::INFINITY, f64::min);
        let (_, y) = curve(&[(-1.0, least)])[0];
        chart.draw_series([Text::new(words, (0.42, y - 1.05), style)])?;
    }
    let words = [
        ("hand-rolled f32".to_owned(), AMBER),
        ("hand-rolled f64".to_owned(), RED),
    ];
    key(area, (84.0, 46.0), &words)
}

/// Errors in the plot's coordinates.
fn curve(errors: &[(f64, f64)]) -> Vec<(f64, f64)> {
    errors
        .iter()
        .map(|&(log_p, e)| (stretch(log_p), e.log10().clamp(ERRORS.0, ERRORS.1)))
        .collect()
}

/// The probability at a stretched coordinate.
fn tail_label(x: f64) -> String {
    let log_p = -(10f64.powf(x));
    if log_p > -0.5 {
        "½".to_owned()
    } else {
        power_of_ten(log_p)
    }
}
