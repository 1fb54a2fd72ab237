//! Pictures at several counts of samples, and how far they are apart.

use indicatif::ProgressBar;
use rayon::prelude::*;
use shade_core::{
    Aim, Aligned, Asked, Camera, Meter, Pixel, Place, Scene, Set, Vector, pixel, radiance,
};
use std::hint::black_box;

/// A picture: mean radiance of red, green and blue, pixel by pixel along rows.
pub(super) type Means = Vec<[f64; 3]>;

/// Half as many pixels along each side.
pub(super) fn halved<V: Vector>(camera: &mut Camera<V>) {
    camera.width = (camera.width / 2).max(1);
    camera.height = (camera.height / 2).max(1);
    camera.step = camera.step + camera.step;
}

/// The law of diffuse reflection.
const LAW: coslobe::Lambert = coslobe::Lambert;

type Space<T> = Scene<[T; 3]>;

/// The pictures at each of `counts`, which increase, with numbers that do not depend on the type.
pub(super) fn passes<T: shade_core::Number>(
    scene: &Space<T>,
    set: Set,
    counts: &[u32],
    progress: &ProgressBar,
) -> Vec<Means> {
    let e = Asked(set);
    let (width, height) = (scene.camera.width, scene.camera.height);
    let of_pixel = |x: u16, y: u16| -> Vec<[f64; 3]> {
        let meter = &mut Aligned::<T>::default();
        let aim = Aim::new(scene, e, (x, y), meter);
        let mut sums = Pixel::<T>::default();
        let mut means = Vec::with_capacity(counts.len());
        for &count in counts {
            for sample in sums.count..count {
                let place = Place {
                    pixel: u32::from(y) * u32::from(width) + u32::from(x),
                    sample,
                    seed: scene.seed,
                };
                sums.add(radiance(scene, e, &LAW, &aim, place, meter));
            }
            means.push(sums.mean());
        }
        means
    };
    let rows: Vec<Vec<Vec<[f64; 3]>>> = (0..height)
        .into_par_iter()
        .map(|y| {
            let row = (0..width).map(|x| of_pixel(x, y)).collect();
            progress.inc(1);
            row
        })
        .collect();
    let at = |i: usize| rows.iter().flatten().map(|means| means[i]).collect();
    (0..counts.len()).map(at).collect()
}

/// The picture of `samples` samples.
pub(super) fn reference(
    scene: &Space<f64>,
    set: Set,
    samples: u32,
    progress: &ProgressBar,
) -> Means {
    let rows: Vec<Means> = (0..scene.camera.height)
        .into_par_iter()
        .map(|y| {
            let mean = |x| shaded(scene, set, (x, y), samples, &mut ()).mean();
            let row = (0..scene.camera.width).map(mean).collect();
            progress.inc(1);
            row
        })
        .collect();
    rows.concat()
}

fn shaded<T: shade_core::Number>(
    scene: &Space<T>,
    set: Set,
    at: (u16, u16),
    samples: u32,
    meter: &mut impl Meter,
) -> Pixel<T> {
    pixel(scene, Asked(set), &LAW, at, samples, meter)
}

/// Renders a row on this thread, with each type's own count of words.
pub(super) fn timed<T: shade_core::Number>(scene: &Space<T>, set: Set, y: u16, samples: u32) {
    for x in 0..scene.camera.width {
        black_box(shaded(black_box(scene), set, (x, y), samples, &mut ()));
    }
}

/// Mean over pixels and colours.
pub(super) fn mean(a: &Means) -> f64 {
    a.iter().flatten().sum::<f64>() / (3.0 * a.len().max(1) as f64)
}

/// Root of the mean squared difference over pixels and colours.
pub(super) fn rmse(a: &Means, b: &Means) -> f64 {
    let squares = a.iter().flatten().zip(b.iter().flatten());
    let sum: f64 = squares.map(|(a, b)| (a - b) * (a - b)).sum();
    (sum / (3.0 * a.len().max(1) as f64)).sqrt()
}

/// Of each pixel the difference in the colour that is worst.
fn differences(a: &Means, b: &Means) -> Vec<f64> {
    let worst = |(a, b): (&[f64; 3], &[f64; 3])| {
        let colours = a.iter().zip(b);
        colours.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    a.iter().zip(b).map(worst).collect()
}

/// The median pixel's difference.
pub(super) fn median(a: &Means, b: &Means) -> f64 {
    let mut all = differences(a, b);
    all.sort_unstable_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(0.0)
}

/// How many pixels differ by more than `limit`.
pub(super) fn worse_than(limit: f64, a: &Means, b: &Means) -> usize {
    differences(a, b).into_iter().filter(|&d| d > limit).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_difference_has_its_root_mean_square() {
        let a = vec![[1.0; 3]; 4];
        assert_eq!(rmse(&a, &a), 0.0);
        let mut b = a.clone();
        // One value of twelve is off by 3: 9/12 = ¾.
        b[2][1] += 3.0;
        assert!((rmse(&a, &b) - 0.75f64.sqrt()).abs() < 1e-15);
        // A mean of differences, in place of their squares, would cancel.
        b[3][1] -= 3.0;
        assert!((rmse(&a, &b) - 1.5f64.sqrt()).abs() < 1e-15);
        assert!((mean(&b) - 1.0).abs() < 1e-15);
        // Two pixels of four are off, which the median's is of.
        assert_eq!((median(&a, &b), worse_than(1.0, &a, &b)), (3.0, 2));
        assert_eq!(worse_than(3.0, &a, &b), 0);
    }
}
