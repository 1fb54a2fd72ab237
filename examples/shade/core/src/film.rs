//! What is kept of a pixel.

use crate::{Aim, Effects, Meter, Number, Place, Rgb, Sampling, Scene, Vector, radiance};

/// Sums of a pixel's samples, relative to the first: equal samples have a variance of exactly 0.
///
/// Each sum carries what rounding left of it (Kahan): it is right to 2u, and u²n of its terms'
/// sizes, which at the most samples is still below 2u in the narrowest type. A plain sum would lose
/// its digits as it grows. Source: W. Kahan, *Further remarks on reducing truncation errors*, 1965.
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
    /// What is to be added to `sum` and to `squares`.
    pub rests: [Rgb<T>; 2],
}

/// `sum` + `rest` becomes `sum` + `rest` + x.
#[inline(always)]
fn add<T: Number>(sum: &mut T, rest: &mut T, x: T) {
    let x = x + *rest;
    let next = *sum + x;
    *rest = x - (next - *sum);
    *sum = next;
}

impl<T: Number> Pixel<T> {
    /// One more sample.
    #[inline(always)]
    pub fn add(&mut self, sample: Rgb<T>) {
        if self.count == 0 {
            self.first = sample;
        }
        let [rests, rests_of_squares] = &mut self.rests;
        for (c, &x) in sample.iter().enumerate() {
            let d = x - self.first[c];
            add(&mut self.sum[c], &mut rests[c], d);
            add(&mut self.squares[c], &mut rests_of_squares[c], d * d);
        }
        self.count += 1;
    }
}

impl<T: Number> Pixel<T> {
    /// The pixel `i` (counted along rows) from `count` samples of what `radiance` says at their
    /// places.
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

    /// The same in `f64`, each sum in one number.
    pub fn wide(&self) -> Pixel<f64> {
        let whole = |sum: Rgb<T>, rest: Rgb<T>| -> Rgb<f64> {
            core::array::from_fn(|c| {
                let (sum, rest): (f64, f64) = (sum[c].into(), rest[c].into());
                // An overflow leaves no rest.
                if rest.is_finite() { sum + rest } else { sum }
            })
        };
        Pixel {
            count: self.count,
            first: self.first.map(Into::into),
            sum: whole(self.sum, self.rests[0]),
            squares: whole(self.squares, self.rests[1]),
            rests: [[0.0; 3]; 2],
        }
    }

    /// The mean, in `f64`.
    pub fn mean(&self) -> Rgb<f64> {
        let (wide, n) = (self.wide(), f64::from(self.count));
        core::array::from_fn(|c| wide.first[c] + wide.sum[c] / n)
    }

    /// Variance of one sample, in `f64`; 0 of fewer than two.
    pub fn variance(&self) -> Rgb<f64> {
        let (wide, n) = (self.wide(), f64::from(self.count));
        core::array::from_fn(|c| {
            let (sum, squares) = (wide.sum[c], wide.squares[c]);
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
