//! Surfaces that overlap are lit as one.

use crate::stage::{camera, diffuse, grey, material, v};
use shade_core::effect::{Sky, Sun};
use shade_core::{
    AnyPlanar, AnySpatial, Asked, Number, NumberVisitor, Pixel, Plate, Scene, Vector, every_number,
    pixel,
};

/// Right, up and backward of a world turned out of its axes by two angles.
pub(crate) fn turned([a, b]: [f64; 2]) -> [[f64; 3]; 3] {
    let ((s, c), (t, d)) = (a.sin_cos(), b.sin_cos());
    [[c, s, 0.0], [-s * d, c * d, t], [s * t, -c * t, d]]
}

/// `offset` + the turned `at`.
pub(crate) fn place(axes: [[f64; 3]; 3], offset: [f64; 3], at: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| offset[i] + (0..3).map(|k| axes[k][i] * at[k]).sum::<f64>())
}

/// 64 pixels of a view along the unit vector `forward`, through pixels spread wide.
pub(crate) fn view<V: Vector>(scene: &mut Scene<V>, eye: &[f64], forward: &[f64], step: f64) {
    scene.camera = camera(eye, forward);
    (scene.camera.width, scene.camera.height) = (8, 8);
    scene.camera.filter = V::T::from_f64(1.0);
    scene.camera.step = V::T::from_f64(step);
}

pub(crate) fn pixels<V: Vector>(scene: &Scene<V>, law: &V::Law, samples: u32) -> Vec<Pixel<V::T>> {
    let all = (0..8).flat_map(|y| (0..8).map(move |x| (x, y)));
    let e = Asked(scene.called_for());
    all.map(|at| pixel(scene, e, law, at, samples, &mut ()))
        .collect()
}

pub(crate) fn constant<T: Number>(x: f64) -> Sky<T> {
    Sky {
        nadir: grey(x),
        zenith: grey(x),
    }
}

/// Two plates in one plane, the one turned within it, seen where both are, under a sky of 1 and a
/// sun: they shadow neither each other nor themselves.
#[test]
fn overlapping_plates_are_lit_as_one() {
    struct Lit {
        tilt: [f64; 2],
        offset: [f64; 3],
    }
    impl NumberVisitor for Lit {
        fn number<T: Number>(&mut self) {
            let Lit { tilt, offset } = *self;
            let axes = turned(tilt);
            let [right, up, back] = axes;
            let at = |p| place(axes, offset, p);
            let down = up.map(|x| -x);
            let mut scene = Scene::<[T; 3]>::new(camera(&offset, &down));
            view(&mut scene, &at([0.0, 1.0, 0.0]), &down, 0.05);
            (scene.camera.right, scene.camera.up) = (v(&right), v(&back));
            let grey = material(&mut scene, diffuse(AnySpatial::Lambert, 0.5));
            for (centre, turn, half) in [([0.1, 0.0, 0.0], 0.0f64, 2.0), ([0.0; 3], 0.3, 1.5)] {
                let (s, c) = turn.sin_cos();
                let along = |a: f64, b: f64| v(&place(axes, [0.0; 3], [a, 0.0, b]));
                let plate = Plate {
                    centre: v(&at(centre)),
                    normal: v(&up),
                    axes: [along(c, s), along(-s, c)],
                    half: [T::from_f64(half); 2],
                    material: grey,
                };
                scene.plates.push(plate).expect("room");
            }
            scene.sky = constant(1.0);
            scene.sun = Sun {
                towards: v(&place(axes, [0.0; 3], [0.6, 0.8, 0.0])),
                irradiance: [T::from_f64(std::f64::consts::PI); 3],
            };
            for pixel in pixels(&scene, &AnySpatial::Lambert, 64) {
                let (mean, variance) = (pixel.mean()[0], pixel.variance()[0]);
                // Half of the sky, and half of the sun at cos θ = 0.8.
                assert!(
                    (mean - 0.9).abs() < 1e-5 && variance < 1e-12,
                    "{tilt:?}, {offset:?}: {mean}, variance {variance}"
                );
            }
        }
    }
    for tilt in [[0.0, 0.0], [0.4, 0.3], [1.1, -0.7], [2.5, 0.01]] {
        for offset in [[0.0; 3], [0.3, 0.1, -0.2], [100.0, -70.0, 31.0]] {
            every_number(&mut Lit { tilt, offset });
        }
    }
}

/// In flatland: what shines on a probe from two segments in one line is what shines from one.
#[test]
fn overlapping_segments_are_lit_as_one() {
    struct Lit(f64);
    impl NumberVisitor for Lit {
        fn number<T: Number>(&mut self) {
            let Lit(tilt) = *self;
            let (s, c) = tilt.sin_cos();
            let seen = |lengths: &[f64]| {
                let mut scene = Scene::<[T; 2]>::new(camera(&[0.0; 2], &[0.0; 2]));
                view(&mut scene, &[0.7 - s, 0.2 + c], &[0.0; 2], 0.1);
                let grey = material(&mut scene, diffuse(AnyPlanar::CircleShell, 0.5));
                for &length in lengths {
                    let plate = Plate {
                        centre: v(&[0.7, 0.2]),
                        normal: v(&[-s, c]),
                        axes: [v(&[c, s]), v(&[0.0, 0.0])],
                        half: [length, 0.0].map(T::from_f64),
                        material: grey,
                    };
                    scene.plates.push(plate).expect("room");
                }
                scene.sky = constant(1.0);
                pixels(&scene, &AnyPlanar::CircleShell, 64)
            };
            for (one, two) in seen(&[2.0]).iter().zip(seen(&[1.5, 2.0])) {
                let (one, two) = (one.mean()[0], two.mean()[0]);
                assert!((one - two).abs() < 1e-5, "{tilt}: {one} and {two}");
            }
        }
    }
    for tilt in [0.0, 0.4, 1.1, 2.5] {
        every_number(&mut Lit(tilt));
    }
}
