//! What is kept of a pixel.

use crate::{Aim, Effects, Meter, Number, Place, Rgb, Sampling, Scene, Vector, radiance};

/// Sums of a pixel's samples, relative to the first: equal samples have a variance of exactly 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel<T> {
    /// How many samples.
    pub count: u32,
    /// The first sample.
    pub first: Rgb<T>,
    /// Sum of the differences from it.
    pub sum: Rgb<T>,
    /// Sum of their squares.
    pub squares: Rgb<T>,
}

impl<T: Number> Pixel<T> {
    /// One more sample.
    #[inline(always)]
    pub fn add(&mut self, sample: Rgb<T>) {
        if self.count == 0 {
            self.first = sample;
        }
        for (c, &x) in sample.iter().enumerate() {
            let d = x - self.first[c];
            self.sum[c] = self.sum[c] + d;
            self.squares[c] = self.squares[c] + d * d;
        }
        self.count += 1;
    }
}

impl<T: Number> Pixel<T> {
    /// The pixel `i` (counted along rows) from `count` samples of what `radiance` says at their places.
    #[inline(always)]
    pub fn collect(
        i: u32,
        seed: u32,
        count: u32,
        mut radiance: impl FnMut(Place) -> Rgb<T>,
    ) -> Self {
        let mut pixel = Pixel::default();
        for sample in 0..count {
            let place = Place {
                pixel: i,
                sample,
                seed,
            };
            pixel.add(radiance(place));
        }
        pixel
    }

    /// The mean, in `f64`.
    pub fn mean(&self) -> Rgb<f64> {
        let n = f64::from(self.count);
        core::array::from_fn(|c| self.first[c].into() + self.sum[c].into() / n)
    }

    /// Variance of one sample, in `f64`; 0 of fewer than two.
    pub fn variance(&self) -> Rgb<f64> {
        let n = f64::from(self.count);
        core::array::from_fn(|c| {
            let (sum, squares): (f64, f64) = (self.sum[c].into(), self.squares[c].into());
            let variance = (squares - sum * sum / n) / (n - 1.0);
            if variance > 0.0 { variance } else { 0.0 }
        })
    }
}

/// The pixel (x, y) from `samples` samples.
#[inline]
pub fn pixel<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    scene: &Scene<V>,
    e: E,
    law: &L,
    (x, y): (u16, u16),
    samples: u32,
    meter: &mut M,
) -> Pixel<V::T> {
    let i = u32::from(y) * u32::from(scene.camera.width) + u32::from(x);
    let aim = Aim::new(scene, e, (x, y), meter);
    Pixel::collect(i, scene.seed, samples, |place| {
        radiance(scene, e, law, &aim, place, meter)
    })
}
