//! Surfaces that touch: overlapping plates are lit as one, and no light gets through where walls meet.

use crate::stage::{camera, diffuse, grey, material, sphere, v};
use coslobe::{Fast, Precise};
use shade_core::effect::{Sky, Sun};
use shade_core::{AnyPlanar, AnySpatial, Asked, Number, Pixel, Plate, Scene, Vector, pixel};

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
fn view<V: Vector>(scene: &mut Scene<V>, eye: &[f64], forward: &[f64], step: f64) {
    scene.camera = camera(eye, forward);
    (scene.camera.width, scene.camera.height) = (8, 8);
    scene.camera.filter = V::T::from_f64(1.0);
    scene.camera.step = V::T::from_f64(step);
}

fn pixels<V: Vector>(scene: &Scene<V>, law: &V::Law, samples: u32) -> Vec<Pixel<V::T>> {
    let all = (0..8).flat_map(|y| (0..8).map(move |x| (x, y)));
    let e = Asked(scene.called_for());
    all.map(|at| pixel(scene, e, law, at, samples, &mut ()))
        .collect()
}

fn constant<T: Number>(x: f64) -> Sky<T> {
    Sky {
        nadir: grey(x),
        zenith: grey(x),
    }
}

/// Two plates in one plane, the one turned within it, seen where both are, under a sky of 1 and a sun: they
/// shadow neither each other nor themselves.
#[test]
fn overlapping_plates_are_lit_as_one() {
    fn check<T: Number>(tilt: [f64; 2], offset: [f64; 3]) {
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
    for tilt in [[0.0, 0.0], [0.4, 0.3], [1.1, -0.7], [2.5, 0.01]] {
        for offset in [[0.0; 3], [0.3, 0.1, -0.2], [100.0, -70.0, 31.0]] {
            check::<f32>(tilt, offset);
            check::<f64>(tilt, offset);
            check::<Fast<f32>>(tilt, offset);
            check::<Precise<f32>>(tilt, offset);
        }
    }
}

/// In flatland: what shines on a probe from two segments in one line is what shines from one.
#[test]
fn overlapping_segments_are_lit_as_one() {
    fn check<T: Number>(tilt: f64) {
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
    for tilt in [0.0, 0.4, 1.1, 2.5] {
        check::<f32>(tilt);
        check::<f64>(tilt);
        check::<Fast<f32>>(tilt);
        check::<Precise<f32>>(tilt);
    }
}

/// Samples of a room under a sky of 1 that saw some of it.
fn leaks<V: Vector>(mut scene: Scene<V>, own: V::Law, samples: u32) -> usize {
    material(&mut scene, diffuse(own, 1.0));
    scene.sky = constant(1.0);
    scene.bounces = 32;
    let pixels = pixels(&scene, &own, samples);
    pixels
        .iter()
        .filter(|p| !(p.mean()[0] == 0.0 && p.variance()[0] == 0.0))
        .count()
}

pub(crate) const FAR: [f64; 3] = [3000.1, -2100.0, 930.0];

/// A room of six plates.
pub(crate) fn room<T: Number>(tilt: [f64; 2], offset: [f64; 3], half: [f64; 3]) -> Scene<[T; 3]> {
    let axes = turned(tilt);
    let mut scene = Scene::<[T; 3]>::new(camera(&offset, &[0.0, 0.0, -1.0]));
    view(&mut scene, &offset, &[0.0, 0.0, -1.0], 0.2);
    for i in 0..3 {
        for side in [-1.0, 1.0] {
            let mut at = [0.0; 3];
            at[i] = side * half[i];
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let plate = Plate {
                centre: v(&place(axes, offset, at)),
                normal: v(&axes[i]),
                axes: [v(&axes[j]), v(&axes[k])],
                half: [half[j], half[k]].map(T::from_f64),
                material: 0,
            };
            scene.plates.push(plate).expect("room");
        }
    }
    scene
}

#[test]
fn closed_rooms_are_dark() {
    fn check<T: Number>(samples: u32) {
        for offset in [[0.0; 3], [100.1, -70.0, 31.0], FAR] {
            for (tilt, half) in [
                ([0.0; 2], [1.0; 3]),
                ([0.4, 0.3], [0.7, 1.3, 0.9]),
                ([1.1, -0.7], [20.0, 3.0, 5.0]),
            ] {
                let room = room::<T>(tilt, offset, half);
                assert_eq!(
                    leaks(room, AnySpatial::Lambert, samples),
                    0,
                    "{tilt:?} {offset:?}"
                );
            }
        }
    }
    check::<f32>(1 << 9);
    check::<Fast<f32>>(1 << 8);
    check::<Precise<f32>>(1 << 6);
    check::<f64>(1 << 7);
    // A window is seen.
    let mut open = room::<f32>([0.0; 2], FAR, [1.0; 3]);
    open.plates[5].half[0] = 0.99;
    assert!(leaks(open, AnySpatial::Lambert, 1 << 7) > 0);
}

/// Polygons of segments, whose corners are blunt, right and sharp.
#[test]
fn closed_polygons_are_dark() {
    fn check<T: Number>() {
        for offset in [[0.0; 2], [100.1, -70.0], [FAR[0], FAR[1]]] {
            for sides in [3, 4, 5, 8] {
                let corner = |i: usize| {
                    let (s, c) = (0.3 + std::f64::consts::TAU * i as f64 / sides as f64).sin_cos();
                    [offset[0] + 3.0 * c, offset[1] + 2.0 * s]
                };
                let mut scene = Scene::<[T; 2]>::new(camera(&offset, &[0.0; 2]));
                view(&mut scene, &offset, &[0.0; 2], 0.05);
                for i in 0..sides {
                    let ([a, b], [c, d]) = (corner(i), corner(i + 1));
                    let length = (c - a).hypot(d - b);
                    let along = [(c - a) / length, (d - b) / length];
                    let plate = Plate {
                        centre: v(&[(a + c) / 2.0, (b + d) / 2.0]),
                        normal: v(&[-along[1], along[0]]),
                        axes: [v(&along), v(&[0.0; 2])],
                        half: [length / 2.0, 0.0].map(T::from_f64),
                        material: 0,
                    };
                    scene.plates.push(plate).expect("room");
                }
                let found = leaks(scene, AnyPlanar::CircleShell, 1 << 9);
                assert_eq!(found, 0, "{sides} sides at {offset:?}");
            }
        }
    }
    check::<f32>();
    check::<Fast<f32>>();
    check::<Precise<f32>>();
    check::<f64>();
}

/// A hollow sphere with a floor through it, and one with a ball at its wall.
#[test]
fn closed_spheres_are_dark() {
    fn check<V: Vector>(own: V::Law, offset: &[f64]) {
        let shifted = |dy: f64| {
            let mut centre = offset.to_vec();
            centre[1] += dy;
            centre
        };
        for floor in [true, false] {
            let mut scene = Scene::<V>::new(camera(offset, &[0.6, -0.8, 0.0]));
            view(&mut scene, offset, &[0.6, -0.8, 0.0], 0.05);
            scene.spheres.push(sphere(offset, 1.5, 0)).expect("room");
            if floor {
                let half = [2.0, if V::DIM == 3 { 2.0 } else { 0.0 }];
                let plate = Plate {
                    centre: v(&shifted(-0.5)),
                    normal: v(&[0.0, 1.0, 0.0]),
                    axes: [v(&[1.0, 0.0, 0.0]), v(&[0.0, 0.0, 1.0])],
                    half: half.map(V::T::from_f64),
                    material: 0,
                };
                scene.plates.push(plate).expect("room");
            } else {
                let ball = sphere(&shifted(-1.2), 0.7, 0);
                scene.spheres.push(ball).expect("room");
            }
            assert_eq!(
                leaks(scene, own, 1 << 8),
                0,
                "{offset:?}, with a floor: {floor}"
            );
        }
    }
    for offset in [[0.0; 3], [100.1, -70.0, 31.0], FAR] {
        check::<[f32; 3]>(AnySpatial::Lambert, &offset);
        check::<[f64; 3]>(AnySpatial::Lambert, &offset);
        check::<[Fast<f32>; 3]>(AnySpatial::Lambert, &offset);
        check::<[Precise<f32>; 3]>(AnySpatial::Lambert, &offset);
        check::<[f32; 2]>(AnyPlanar::CircleShell, &offset[..2]);
        check::<[f64; 2]>(AnyPlanar::CircleShell, &offset[..2]);
        check::<[Fast<f32>; 2]>(AnyPlanar::CircleShell, &offset[..2]);
        check::<[Precise<f32>; 2]>(AnyPlanar::CircleShell, &offset[..2]);
    }
}
