//! No light gets through where walls meet.

use crate::contact::{constant, pixels, place, turned, view};
use crate::stage::{camera, diffuse, material, sphere, v};
use shade_core::{
    AnyPlanar, AnySpatial, Number, NumberVisitor, Plate, Scene, Vector, every_number,
};

/// Samples of a room under a sky of 1 that saw some of it; of 64 bits, which have the digits, fewer
/// are tried.
fn leaks<V: Vector>(mut scene: Scene<V>, own: V::Law, samples: u32) -> usize {
    let samples = if size_of::<V::T>() == 4 {
        samples
    } else {
        samples / 8
    };
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
    struct Dark;
    impl NumberVisitor for Dark {
        fn number<T: Number>(&mut self) {
            for offset in [[0.0; 3], [100.1, -70.0, 31.0], FAR] {
                for (tilt, half) in [
                    ([0.0; 2], [1.0; 3]),
                    ([0.4, 0.3], [0.7, 1.3, 0.9]),
                    ([1.1, -0.7], [20.0, 3.0, 5.0]),
                ] {
                    let room = room::<T>(tilt, offset, half);
                    assert_eq!(
                        leaks(room, AnySpatial::Lambert, 1 << 8),
                        0,
                        "{tilt:?} {offset:?}"
                    );
                }
            }
        }
    }
    every_number(&mut Dark);
    // A window is seen.
    let mut open = room::<f32>([0.0; 2], FAR, [1.0; 3]);
    open.plates[5].half[0] = 0.99;
    assert!(leaks(open, AnySpatial::Lambert, 1 << 7) > 0);
}

/// Polygons of segments, whose corners are blunt, right and sharp.
#[test]
fn closed_polygons_are_dark() {
    struct Dark;
    impl NumberVisitor for Dark {
        fn number<T: Number>(&mut self) {
            for offset in [[0.0; 2], [100.1, -70.0], [FAR[0], FAR[1]]] {
                for sides in [3, 4, 5, 8] {
                    let corner = |i: usize| {
                        let (s, c) =
                            (0.3 + std::f64::consts::TAU * i as f64 / sides as f64).sin_cos();
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
    }
    every_number(&mut Dark);
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
    struct Dark;
    impl NumberVisitor for Dark {
        fn number<T: Number>(&mut self) {
            for offset in [[0.0; 3], [100.1, -70.0, 31.0], FAR] {
                check::<[T; 3]>(AnySpatial::Lambert, &offset);
                check::<[T; 2]>(AnyPlanar::CircleShell, &offset[..2]);
            }
        }
    }
    every_number(&mut Dark);
}
