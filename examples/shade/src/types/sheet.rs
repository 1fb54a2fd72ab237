//! The contact sheet: the picture, and how far each type is from it.

use super::Study;
use super::draw::{Means, median, rmse};
use crate::image::encoded;

/// Pictures along a row, rows: the picture, its noise, the differences of the other types.
pub(super) const LAYOUT: (u16, u16) = (3, 2);

/// What makes differences visible: the power of ten that brings the median pixel's near 0.02.
fn gain(median: f64) -> f64 {
    if median > 0.0 {
        libm::pow(10.0, (0.02 / median).log10().round())
    } else {
        1.0
    }
}

/// Each difference's gain, and the sheet's bytes: the picture at the most samples, then how far it
/// is from the converged one and from those of the other types, in the order of `studies`, whose
/// last it is.
pub(super) fn sheet(
    studies: &[Study],
    converged: &Means,
    (width, height): (u16, u16),
    exposure: f64,
) -> (Vec<f64>, Vec<u8>) {
    let (columns, lines) = (usize::from(LAYOUT.0), usize::from(LAYOUT.1));
    let (width, height) = (usize::from(width), usize::from(height));
    let mut rgb = vec![0; 3 * columns * width * lines * height];
    let mut put = |place: usize, values: &mut dyn FnMut(usize) -> [f64; 3]| {
        let (left, top) = (place % columns * width, place / columns * height);
        for i in 0..width * height {
            let at = (top + i / width) * columns * width + left + i % width;
            rgb[3 * at..3 * at + 3].copy_from_slice(&values(i).map(encoded));
        }
    };
    let Some((best, others)) = studies.split_last() else {
        return (Vec::new(), rgb);
    };
    let Some(best) = best.means.last() else {
        return (Vec::new(), rgb);
    };
    put(0, &mut |i| best[i].map(|x| x * exposure));
    let mut gains = Vec::new();
    let others = others.iter().filter_map(|s| s.means.last());
    for (place, means) in std::iter::once(converged).chain(others).enumerate() {
        let gain = gain(match median(means, best) {
            0.0 => rmse(means, best), // most pixels are the same
            median => median,
        });
        put(place + 1, &mut |i| difference(means, best, i, gain));
        gains.push(gain);
    }
    (gains, rgb)
}

fn difference(a: &Means, b: &Means, i: usize, gain: f64) -> [f64; 3] {
    std::array::from_fn(|c| (a[i][c] - b[i][c]).abs() * gain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gains_are_powers_of_ten() {
        assert_eq!(gain(0.02), 1.0);
        assert_eq!(gain(4e-7), 1e5);
        assert_eq!(gain(0.0), 1.0);
    }

    #[test]
    fn a_planted_difference_is_seen_where_it_is() {
        let study = |means: Means| Study {
            name: "",
            means: vec![means],
            timed: Box::new(|_| ()),
            seconds: vec![1.0],
        };
        let even = vec![[0.25; 3]; 2];
        let mut planted = even.clone();
        planted[1][2] += 1e-3;
        let studies = [study(even.clone()), study(even)];
        let (gains, rgb) = sheet(&studies, &planted, (2, 1), 1.0);
        assert_eq!(gains, [10.0, 1.0]);
        // Of the first row the second picture's last value alone is not black.
        assert!(rgb[..6].iter().all(|&x| x == encoded(0.25)));
        assert_eq!(rgb[6..12], [0, 0, 0, 0, 0, encoded(0.01)]);
        assert!(rgb[12..].iter().all(|&x| x == 0));
    }
}
