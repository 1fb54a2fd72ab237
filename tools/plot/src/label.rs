//! Labels beside points, placed so that none covers another.

use crate::canvas::{Area, Drawn, FAINT, line, px, text};
use plotters::prelude::*;

/// Height of a label, and about the width of a letter, in pixels.
const HEIGHT: f64 = 10.5;
const LETTER: f64 = 5.5;

/// A point in pixels from the area's corner.
pub struct Mark {
    pub x: f64,
    pub y: f64,
    pub words: String,
    pub color: RGBColor,
    pub shape: Shape,
}

/// What a point is drawn as.
#[derive(Clone, Copy, PartialEq)]
pub enum Shape {
    /// Of ours.
    Disk,
    Triangle,
    Square,
    Diamond,
    /// Of a peer.
    Dot,
    Cross,
}

impl Shape {
    fn ours(self) -> bool {
        !matches!(self, Shape::Dot | Shape::Cross)
    }
}

/// Draws a shape around (x, y).
pub fn shape(area: &Area, shape: Shape, (x, y): (f64, f64), color: RGBColor) -> Drawn {
    let corners = |r: f64, all: &[(f64, f64)]| {
        let at = |&(dx, dy): &(f64, f64)| (px(x + r * dx), px(y + r * dy));
        Polygon::new(all.iter().map(at).collect::<Vec<_>>(), color.filled())
    };
    let at = (px(x), px(y));
    match shape {
        Shape::Disk => area.draw(&Circle::new(at, px(4.0), color.filled()))?,
        Shape::Dot => area.draw(&Circle::new(at, px(3.0), color.filled()))?,
        Shape::Cross => area.draw(&Cross::new(at, px(3.2), line(color, 1.5)))?,
        Shape::Triangle => area.draw(&corners(5.0, &[(0.0, -1.0), (0.9, 0.65), (-0.9, 0.65)]))?,
        Shape::Square => {
            let ends = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            area.draw(&corners(3.6, &ends))?;
        }
        Shape::Diamond => {
            let ends = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)];
            area.draw(&corners(5.2, &ends))?;
        }
    }
    Ok(())
}

#[derive(Clone, Copy)]
struct Rect {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

impl Rect {
    fn meets(&self, other: &Rect) -> f64 {
        let width = self.right.min(other.right) - self.left.max(other.left);
        let height = self.bottom.min(other.bottom) - self.top.max(other.top);
        width.max(0.0) * height.max(0.0)
    }
}

/// Draws the marks with their words within `frame` (left, top, right, bottom), clear of a path of
/// upright and level `steps`.
pub fn draw(
    area: &Area,
    marks: &[Mark],
    steps: &[(f64, f64)],
    frame: (f64, f64, f64, f64),
) -> Drawn {
    let mut taken: Vec<Rect> = marks.iter().map(|m| around(m, 5.0)).collect();
    taken.extend(steps.windows(2).map(|ends| Rect {
        left: ends[0].0.min(ends[1].0) - 1.0,
        top: ends[0].1.min(ends[1].1) - 1.0,
        right: ends[0].0.max(ends[1].0) + 1.0,
        bottom: ends[0].1.max(ends[1].1) + 1.0,
    }));
    let mut order: Vec<&Mark> = marks.iter().collect();
    // Ours first: they get the nearest places.
    order.sort_by_key(|m| !m.shape.ours());
    for mark in order.iter().filter(|m| !m.words.is_empty()) {
        let place = place(mark, &taken, frame);
        taken.push(place);
        let near_x = mark.x.clamp(place.left, place.right);
        let near_y = mark.y.clamp(place.top, place.bottom);
        if (near_x - mark.x).hypot(near_y - mark.y) > 9.0 {
            let ends = [(mark.x, mark.y), (near_x, near_y)];
            let ends = ends.map(|(x, y)| (px(x), px(y)));
            area.draw(&PathElement::new(ends.to_vec(), line(FAINT, 0.9)))?;
        }
        let at = (px(place.left + 1.0), px(place.top));
        let style = text(mark.color, HEIGHT);
        area.draw(&Text::new(mark.words.clone(), at, style))?;
    }
    for mark in order {
        shape(area, mark.shape, (mark.x, mark.y), mark.color)?;
    }
    Ok(())
}

fn around(mark: &Mark, r: f64) -> Rect {
    Rect {
        left: mark.x - r,
        top: mark.y - r,
        right: mark.x + r,
        bottom: mark.y + r,
    }
}

/// The free place nearest to the mark.
fn place(mark: &Mark, taken: &[Rect], (left, top, right, bottom): (f64, f64, f64, f64)) -> Rect {
    let width = LETTER * mark.words.chars().count() as f64 + 2.0;
    let mut best = (f64::INFINITY, around(mark, 5.0));
    for step in 0..16 {
        for turn in 0..24 {
            let (s, c) = (f64::from(turn) * std::f64::consts::TAU / 24.0).sin_cos();
            let reach = 8.0 + 6.0 * f64::from(step);
            let (x, y) = (mark.x + reach * c, mark.y + 0.8 * reach * s);
            // The side that faces the mark touches (x, y).
            let x = x - width * (1.0 - c) / 2.0;
            let rect = Rect {
                left: x,
                top: y - HEIGHT / 2.0 - 1.0,
                right: x + width,
                bottom: y + HEIGHT / 2.0 + 2.0,
            };
            let outside = rect.left < left || rect.right > right;
            if outside || rect.top < top || rect.bottom > bottom {
                continue;
            }
            let covered: f64 = taken.iter().map(|t| t.meets(&rect)).sum();
            let cost = 50.0 * covered + reach + if c < 0.0 { 1.0 } else { 0.0 };
            if cost < best.0 {
                best = (cost, rect);
            }
        }
    }
    best.1
}
