//! A plotters canvas with one palette and finer coordinates than whole pixels.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;

/// plotters rounds to whole units; with eight a pixel its curves are smooth.
pub const FINE: u32 = 8;

pub const PAPER: RGBColor = RGBColor(252, 252, 250);
pub const INK: RGBColor = RGBColor(38, 43, 56);
pub const MUTED: RGBColor = RGBColor(104, 111, 128);
pub const FAINT: RGBColor = RGBColor(214, 218, 226);
/// The density, and f64.
pub const BLUE: RGBColor = RGBColor(37, 99, 175);
/// f32.
pub const TEAL: RGBColor = RGBColor(15, 140, 121);
/// Points and what is hand-rolled.
pub const AMBER: RGBColor = RGBColor(217, 119, 6);
pub const RED: RGBColor = RGBColor(190, 58, 72);

const FONT: &str = "Inter, Segoe UI, Helvetica Neue, Arial, DejaVu Sans, sans-serif";

pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub type Drawn = Result<(), Box<dyn Error>>;

/// Pixels in the canvas's units.
pub fn px(pixels: f64) -> i32 {
    (pixels * f64::from(FINE)).round() as i32
}

/// A line `pixels` wide.
pub fn line(color: RGBColor, pixels: f64) -> ShapeStyle {
    color.stroke_width(px(pixels) as u32)
}

/// Text of `pixels` height; plotters divides sizes by 1.24.
pub fn text(color: RGBColor, pixels: f64) -> TextStyle<'static> {
    let mut style = TextStyle::from((FONT, pixels * 1.24 * f64::from(FINE)).into_font());
    style.color = color.to_backend_color();
    style
}

pub fn bold(color: RGBColor, pixels: f64) -> TextStyle<'static> {
    let mut style = text(color, pixels);
    style.font = style.font.style(FontStyle::Bold);
    style
}

pub fn centred(style: TextStyle<'static>) -> TextStyle<'static> {
    style.pos(Pos::new(HPos::Center, VPos::Center))
}

/// A panel's title.
pub fn heading(area: &Area, words: &str) -> Drawn {
    area.draw(&Text::new(
        words.to_owned(),
        (px(20.0), px(14.0)),
        bold(INK, 14.0),
    ))?;
    Ok(())
}

/// Words in their curve's colour, one after the other from (x, y) down.
pub fn key(area: &Area, (x, y): (f64, f64), words: &[(String, RGBColor)]) -> Drawn {
    for (i, (word, color)) in words.iter().enumerate() {
        let at = (px(x), px(y + 15.0 * i as f64));
        area.draw(&Text::new(word.clone(), at, text(*color, 11.5)))?;
    }
    Ok(())
}

/// An SVG file of `width` × `height` pixels.
pub fn svg(
    (width, height): (u32, u32),
    title: &str,
    draw: impl FnOnce(&Area) -> Drawn,
) -> Result<String, Box<dyn Error>> {
    let mut out = String::new();
    {
        let area =
            SVGBackend::with_string(&mut out, (width * FINE, height * FINE)).into_drawing_area();
        area.fill(&PAPER)?;
        draw(&area)?;
        area.present()?;
    }
    // The size a reader sees, round joints, and a title for those who cannot see.
    let wide = format!(
        "width=\"{}\" height=\"{}\" viewBox",
        width * FINE,
        height * FINE
    );
    let shown = format!(
        "width=\"{width}\" height=\"{height}\" role=\"img\" stroke-linejoin=\"round\" viewBox"
    );
    if !out.contains(&wide) {
        return Err("plotters' SVG header is not the expected one".into());
    }
    let out = out.replacen(&wide, &shown, 1);
    Ok(out.replacen(">\n", &format!(">\n<title>{title}</title>\n"), 1))
}
