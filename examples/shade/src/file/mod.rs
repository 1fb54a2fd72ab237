//! Scene files: TOML, checked whole before anything is rendered.

mod build;
mod check;
mod error;
mod ranges;
mod raw;
mod worlds;

pub use build::{World, scene};
pub use error::Error;
pub use raw::Raw;

/// Most pixels along a side.
pub const SIDE: i64 = 4096;
/// Most samples of a pixel.
pub const SAMPLES: i64 = 1 << 20;
/// Most scatterings of a path.
pub const BOUNCES: i64 = 64;
/// Longest file, in bytes: a hundred times the longest sensible one.
pub const BYTES: usize = 1 << 18;
/// Largest size of a coordinate, radius, radiance or coefficient, and the least above 0.
pub const LARGEST: f64 = 1e6;
pub const LEAST: f64 = 1e-6;

/// A scene file's text, read and checked; `name` is for the messages.
pub fn parse(name: &str, text: &str) -> Result<Raw, Error> {
    if text.len() > BYTES {
        return Err(Error::new(
            name,
            text,
            0..0,
            format!("longer than the most, {BYTES} bytes"),
        ));
    }
    let raw: Raw = toml::from_str(text).map_err(|e| Error::of_toml(name, text, &e))?;
    check::check(&raw).map_err(|(span, what)| Error::new(name, text, span, what))?;
    Ok(raw)
}
