//! The density in polar form beside the tangent disk or ball it comes from.

use crate::catalog::{Entry, LawName};
use crate::random::stream;
use coslobe::rand_core::Rng;
use plot::canvas::{AMBER, Area, BLUE, Drawn, FAINT, INK, MUTED, centred, line, px, text};
use plotters::prelude::*;
use rand_pcg::Pcg64;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

/// What the picture shows besides the lobe.
pub(crate) struct Detail {
    pub(crate) points: u64,
    pub(crate) point_size: f64,
    pub(crate) degrees: bool,
}

/// Half the width of the picture, in diameters of the tangent disk.
const REACH: f64 = 1.2;

/// A polar curve, θ from +y.
fn polar(r: impl Fn(f64) -> f64, reach: f64) -> Vec<(f64, f64)> {
    (-90..=90)
        .map(|i| {
            let theta = reach * f64::from(i) / 90.0;
            (r(theta) * theta.sin(), r(theta) * theta.cos())
        })
        .collect()
}

/// Draws into `area`, with the origin low in its middle and the axes to one scale.
pub(crate) fn draw(area: &Area, entry: &Entry, seed: u64, detail: &Detail) -> Drawn {
    let (width, height) = area.dim_in_pixel();
    let tall = 2.0 * REACH * f64::from(height) / f64::from(width);
    let mut chart = ChartBuilder::on(area).build_cartesian_2d(-REACH..REACH, -0.09..tall - 0.09)?;

    for degrees in [-90, -60, -30, 0, 30, 60, 90] {
        let (sin, cos) = (f64::from(degrees) * PI / 180.0).sin_cos();
        let ray = [(0.0, 0.0), (1.04 * sin, 1.04 * cos)];
        chart.draw_series([PathElement::new(ray, line(FAINT, 0.8))])?;
        if detail.degrees {
            let label = format!("{degrees}°").replace('-', "−");
            let style = centred(text(MUTED, 10.5));
            chart.draw_series([Text::new(label, (1.16 * sin, 1.16 * cos), style)])?;
        }
    }
    for r in [0.5, 1.0] {
        let arc = polar(|_| r, FRAC_PI_2);
        chart.draw_series([PathElement::new(arc, line(FAINT, 0.8))])?;
    }

    let probe = &entry.double.probe;
    let peak = probe.lobe(0.0);
    // A needle of a lobe needs its points where it is.
    let (_, reach) = entry.double.shape.window();
    let lobe = polar(|theta| probe.lobe(theta.abs()) / peak, reach);
    let mut filled = lobe.clone();
    filled.push((0.0, 0.0));
    chart.draw_series([Polygon::new(filled, BLUE.mix(0.13))])?;

    if entry.point.is_some() {
        // The circle r = cos θ: diameter 1, tangent to the x axis at the origin.
        let circle = polar(f64::cos, FRAC_PI_2);
        chart.draw_series([PathElement::new(circle, line(INK, 1.1))])?;
    }
    chart.draw_series([PathElement::new(lobe, line(BLUE, 2.0))])?;
    if let Some(point) = &entry.point {
        let mut rng = stream(seed, (entry.name as u64) << 44);
        let size = px(detail.point_size) as u32;
        let dots = (0..detail.points).map(|_| {
            let at = thickened(entry.name, point(&mut rng), &mut rng);
            Circle::new(at, size, AMBER.mix(0.7).filled())
        });
        chart.draw_series(dots)?;
    }
    chart.draw_series([Circle::new((0.0, 0.0), px(2.6) as u32, INK.filled())])?;
    if reach < FRAC_PI_6 / 30.0 {
        let style = centred(text(MUTED, 10.5));
        chart.draw_series([Text::new("too narrow to see", (0.6, 0.3), style)])?;
    }
    Ok(())
}

/// A point of a circle moved out within the thin shell whose limit the law's measure is: on the
/// circle itself dots would run into a line, and the two shells would look alike.
fn thickened(name: LawName, [x, y]: [f64; 2], rng: &mut Pcg64) -> (f64, f64) {
    // The direction in which the shell is equally thick everywhere.
    let (u, v) = match name {
        LawName::CircleShell => (x, y),
        LawName::CircleArc => (x, y - 0.5),
        _ => return (x, y),
    };
    let step = 0.1 * f64::from(rng.next_u32()) * 2f64.powi(-32) / u.hypot(v).max(1e-9);
    (x + step * u, y + step * v)
}
