//! A frame of a scene, as text.

use crate::Small;
use core::fmt::{self, Write};
use shade_core::{Pixel, Rgb, Scene, pixel};

/// Pixels across.
pub const WIDTH: u16 = 16;
/// Pixels down.
pub const HEIGHT: u16 = 12;
/// Samples of each.
pub const SAMPLES: u32 = 4;

/// All pixels.
pub struct Frame([[Pixel<f32>; WIDTH as usize]; HEIGHT as usize]);

fn shaded<S: Small>(scene: &Scene<S::World>, at: (u16, u16)) -> Pixel<f32> {
    let (effects, law) = (S::Effects::default(), S::Law::default());
    pixel(scene, effects, &law, at, SAMPLES, &mut ())
}

/// What is kept of a pixel, with names.
fn parts(pixel: &Pixel<f32>) -> [(&'static str, &Rgb<f32>); 5] {
    [
        ("first", &pixel.first),
        ("sum", &pixel.sum),
        ("squares", &pixel.squares),
        ("sum_rest", &pixel.rests[0]),
        ("squares_rest", &pixel.rests[1]),
    ]
}

/// All bits of one pixel in one word: what the proofs of images call.
pub fn words<S: Small>(scene: &Scene<S::World>, at: (u16, u16)) -> u32 {
    let pixel = shaded::<S>(scene, at);
    let values = parts(&pixel).into_iter().flat_map(|(_, rgb)| rgb);
    values.fold(0, |sum, x| sum.rotate_left(5) ^ x.to_bits())
}

impl Frame {
    /// Black.
    pub fn new() -> Self {
        Frame([[Pixel::default(); WIDTH as usize]; HEIGHT as usize])
    }

    /// Renders.
    pub fn render<S: Small>(&mut self, scene: &Scene<S::World>) {
        for (y, row) in (0..).zip(&mut self.0) {
            for (x, pixel) in (0..).zip(row) {
                *pixel = shaded::<S>(scene, (x, y));
            }
        }
    }

    /// Writes the bits of every pixel, one a line.
    ///
    /// # Errors
    /// If `out` cannot be written to.
    pub fn write<S: Small>(&self, out: &mut impl Write) -> fmt::Result {
        for (y, row) in self.0.iter().enumerate() {
            for (x, pixel) in row.iter().enumerate() {
                write!(out, "{} ({x}, {y}):", S::NAME)?;
                for (name, [r, g, b]) in parts(pixel) {
                    let [r, g, b] = [r, g, b].map(|x| x.to_bits());
                    write!(out, " {name} {r:08x} {g:08x} {b:08x}")?;
                }
                writeln!(out)?;
            }
        }
        Ok(())
    }
}

impl Default for Frame {
    fn default() -> Self {
        Frame::new()
    }
}
