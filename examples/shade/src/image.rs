//! A frame of pixels: what is known of its noise, and its PNG.

use crate::args::Share;
use output::File;
use shade_core::Pixel;

/// Side of a block of pixels, the unit of work.
pub(crate) const BLOCK: u16 = 16;

/// All pixels; those that are not rendered have no samples.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) pixels: Vec<Pixel<f64>>,
}

impl Frame {
    pub(crate) fn new(width: u16, height: u16) -> Frame {
        let pixels = vec![Pixel::default(); usize::from(width) * usize::from(height)];
        Frame {
            width,
            height,
            pixels,
        }
    }

    /// The blocks of a share: every n-th, so that shares take about equally long.
    pub(crate) fn blocks_of(&self, share: Share) -> impl Iterator<Item = u32> + use<> {
        let columns = u32::from(self.width.div_ceil(BLOCK));
        let rows = u32::from(self.height.div_ceil(BLOCK));
        (0..columns * rows).filter(move |b| b % share.of == share.index - 1)
    }

    /// The pixels (x, y) of a block.
    pub(crate) fn places(&self, block: u32) -> impl Iterator<Item = (u16, u16)> + use<> {
        let columns = u32::from(self.width.div_ceil(BLOCK));
        let left = (block % columns) as u16 * BLOCK;
        let top = (block / columns) as u16 * BLOCK;
        let right = (left + BLOCK).min(self.width);
        (top..(top + BLOCK).min(self.height)).flat_map(move |y| (left..right).map(move |x| (x, y)))
    }

    fn index(&self, (x, y): (u16, u16)) -> usize {
        usize::from(y) * usize::from(self.width) + usize::from(x)
    }

    pub(crate) fn get(&self, at: (u16, u16)) -> &Pixel<f64> {
        &self.pixels[self.index(at)]
    }

    pub(crate) fn put(&mut self, block: u32, pixels: &[Pixel<f64>]) {
        for (at, pixel) in self.places(block).zip(pixels) {
            let i = self.index(at);
            self.pixels[i] = *pixel;
        }
    }

    /// (mean radiance, root of the mean squared standard error) over pixels and colours.
    pub(crate) fn noise(&self) -> (f64, f64) {
        let known: Vec<&Pixel<f64>> = self.pixels.iter().filter(|p| p.count > 0).collect();
        let n = 3.0 * known.len().max(1) as f64;
        let mean = known.iter().flat_map(|p| p.mean()).sum::<f64>() / n;
        let squares = known.iter().filter(|p| p.count > 1);
        let squares = squares.flat_map(|p| p.variance().map(|v| v / f64::from(p.count)));
        (mean, (squares.sum::<f64>() / n).sqrt())
    }

    /// 8-bit sRGB.
    pub(crate) fn bytes(&self, exposure: f64) -> Vec<u8> {
        self.pixels
            .iter()
            .flat_map(|p| p.mean().map(|x| encoded(x * exposure)))
            .collect()
    }

    /// Whether every pixel is a number; which is not.
    pub(crate) fn check(&self) -> Result<(), String> {
        let is_number = |p: &Pixel<f64>| p.count == 0 || p.mean().iter().all(|x| x.is_finite());
        match self.pixels.iter().position(|p| !is_number(p)) {
            None => Ok(()),
            Some(i) => {
                let (x, y) = (i % usize::from(self.width), i / usize::from(self.width));
                let mean = self.pixels[i].mean();
                Err(format!(
                    "pixel ({x}, {y}) is {mean:?}; expected finite numbers"
                ))
            }
        }
    }

    /// Writes the image whole, or not at all.
    pub(crate) fn write_png(&self, out: &File, exposure: f64) -> Result<(), String> {
        write_png(out, self.width, self.height, &self.bytes(exposure))
    }
}

/// Writes 8-bit sRGB whole, or not at all.
pub(crate) fn write_png(out: &File, width: u16, height: u16, rgb: &[u8]) -> Result<(), String> {
    let mut data = Vec::new();
    let mut encoder = png::Encoder::new(&mut data, width.into(), height.into());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(|e| e.to_string())?;
    writer
        .write_image_data(rgb)
        .and_then(|()| writer.finish())
        .map_err(|e| e.to_string())?;
    out.write(&data)
}

/// The transfer function of sRGB, with a power whose bits do not depend on the system.
pub(crate) fn encoded(x: f64) -> u8 {
    let x = x.clamp(0.0, 1.0);
    let y = if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * libm::pow(x, 1.0 / 2.4) - 0.055
    };
    (y * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pixel_that_is_no_number_is_named() {
        let mut frame = Frame::new(4, 3);
        frame.pixels.iter_mut().for_each(|p| p.add([0.5; 3]));
        assert_eq!(frame.check(), Ok(()));
        for planted in [f64::NAN, f64::INFINITY] {
            let mut frame = frame.clone();
            frame.pixels[9].add([0.5, planted, 0.5]);
            let said = frame.check().expect_err("planted");
            assert!(said.starts_with("pixel (1, 2) is [0.5, "), "{said}");
        }
    }
}
