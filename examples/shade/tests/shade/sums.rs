//! Sums of many samples keep their digits.

use crate::stage::{camera, grey, level, material, v};
use shade_core::{
    AnySpatial, Asked, Material, Number, NumberVisitor, Pixel, Scene, every_number, pixel,
};

/// An emitter of 0.7 over 5 % of the pixel, 2²⁰ samples.
#[test]
fn a_small_emitter_is_as_bright_as_it_is() {
    struct Sums;
    impl NumberVisitor for Sums {
        fn number<T: Number>(&mut self) {
            let samples = if size_of::<T>() == 4 {
                1 << 20
            } else {
                1 << 18
            };
            let mut scene = Scene::<[T; 3]>::new(camera(&[0.0, 1.0, 0.0], &[0.0, -1.0, 0.0]));
            scene.camera.filter = T::from_f64(1.0);
            scene.camera.up = v(&[0.0, 0.0, -1.0]);
            let shining = Material::new(grey(0.0), grey(0.0), AnySpatial::Lambert, grey(0.7));
            let shining = material(&mut scene, shining);
            scene
                .plates
                .push(level(0.0, [-0.25, -0.05], [0.25, 0.05], shining))
                .expect("room");
            let e = Asked(scene.called_for());
            let mut pixels = [Pixel::<f64>::default(); 4];
            for (seed, pixel_) in (0..).zip(&mut pixels) {
                scene.seed = seed;
                *pixel_ = pixel(&scene, e, &AnySpatial::Lambert, (0, 0), samples, &mut ()).wide();
            }
            for pixel in pixels {
                // The samples are 0 or 0.7: their mean square says how many shone.
                let shone = pixel.mean()[0] / 0.7;
                let error = (shone * (1.0 - shone) / f64::from(samples)).sqrt();
                assert!((shone - 0.05).abs() < 5.0 * error, "{shone} ± {error}");
                let variance = pixel.variance()[0] / (0.49 * shone * (1.0 - shone));
                assert!((variance - 1.0).abs() < 1e-4, "{variance}");
            }
        }
    }
    every_number(&mut Sums);
}

/// Against the sum in whole numbers, where terms differ by eight orders.
#[test]
fn sums_are_right_to_their_last_digits() {
    let mut pixel = Pixel::<f32>::default();
    let (mut sum, mut squares) = (0u128, 0u128);
    let mut x = 1u32;
    let samples = 1 << 22;
    for i in 0..samples {
        x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        // At most 24 bits, so that the term and its difference from the first, 0, are exact.
        let term = if i == 0 { 0 } else { x >> 8 >> (x & 15) };
        let sample = term as f32;
        pixel.add([sample; 3]);
        sum += u128::from(term);
        squares += u128::from(term) * u128::from(term);
    }
    let wide = pixel.wide();
    let close = |have: f64, want: u128, error: f64| (have / want as f64 - 1.0).abs() < error;
    assert!(close(wide.sum[1], sum, 1e-9), "{} of {sum}", wide.sum[1]);
    // Each square is rounded once.
    assert!(
        close(wide.squares[1], squares, 1e-8),
        "{} of {squares}",
        wide.squares[1]
    );
    assert!(!close(wide.sum[1], sum + sum / 1_000_000, 1e-9));
}
