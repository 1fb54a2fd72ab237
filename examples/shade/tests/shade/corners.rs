//! Rays into the corners and edges of closed rooms: none gets out, and what each leads to lies
//! inside, which exact signs decide. Pictures alone would need 10⁹ samples to show as little.

use crate::contact::{place, turned};
use crate::leaks::{FAR, room};
use crate::stage::v;
use coslobe::rand_core::Rng;
use kit::accuracy::double::Double;
use rayon::prelude::*;
use shade_core::{
    Effect, Hit, Number, NumberVisitor, Place, Ray, Scene, Stream, Target, Vector, every_number,
};

/// Turn, offset and half the sides of a room.
type Room = ([f64; 2], [f64; 3], [f64; 3]);

const ROOMS: [Room; 6] = [
    ([0.0; 2], FAR, [1.0; 3]),
    ([0.4, 0.3], FAR, [0.7, 1.3, 0.9]),
    ([1.1, -0.7], FAR, [20.0, 3.0, 5.0]),
    ([2.5, 0.01], FAR, [1.0, 0.05, 2.0]),
    ([0.4, 0.3], [100.1, -70.0, 31.0], [0.7, 1.3, 0.9]),
    ([1.1, -0.7], [0.0; 3], [1.0; 3]),
];

/// Rays of one path.
const PATH: u32 = 32;

/// How a hit leads to the next ray's origin.
type Vertex<T> = fn(&Scene<[T; 3]>, &Ray<[T; 3]>, Hit<T>) -> [T; 3];

fn kept<T: Number>(scene: &Scene<[T; 3]>, ray: &Ray<[T; 3]>, hit: Hit<T>) -> [T; 3] {
    scene.surface(ray, hit).expect("a plate").0
}

fn nearest<T: Number>(scene: &Scene<[T; 3]>, ray: &Ray<[T; 3]>) -> Hit<T> {
    let mut hit = Hit::nothing();
    for (i, plate) in scene.plates.iter().enumerate() {
        hit.nearer(plate.hit(ray), Target::plate(i));
    }
    hit
}

/// Whether `p` is on the inner side of all six planes, to the last bit of what they are rounded to.
fn is_inside<T: Number>(scene: &Scene<[T; 3]>, p: [T; 3]) -> bool {
    scene.plates.iter().enumerate().all(|(i, plate)| {
        let inward = if i % 2 == 0 { 1.0 } else { -1.0 };
        let parts: [f64; 3] = core::array::from_fn(|k| {
            (p[k].into() - plate.centre[k].into()) * plate.normal[k].into()
        });
        let (near, size) = parts.iter().fold((0.0, 0.0), |(near, size), part| {
            (near + part, size + part.abs())
        });
        if near.abs() > 1e-14 * size {
            return near * inward > 0.0;
        }
        let height = (0..3).fold(Double::default(), |sum, k| {
            let apart = Double::sum(p[k].into(), -plate.centre[k].into());
            sum + apart * Double::from(plate.normal[k].into())
        });
        height.hi * inward > 0.0
    })
}

/// The direction from `p` to a corner, or to a point of an edge, some units of rounding away; else
/// one along a wall or anywhere.
fn aimed<T: Number>((tilt, offset, half): Room, p: [T; 3], rng: &mut impl Rng) -> [T; 3] {
    let axes = turned(tilt);
    let word = rng.next_u64();
    let unit = |rng: &mut dyn FnMut() -> u64| (rng() >> 11) as f64 * 2f64.powi(-52) - 1.0;
    let next = &mut || rng.next_u64();
    let mut at = half;
    for (i, x) in at.iter_mut().enumerate() {
        *x *= if word >> i & 1 == 0 { 1.0 } else { -1.0 };
    }
    let i = (word >> 8) as usize % 3;
    let kind = word >> 16 & 7;
    if kind == 0 || kind >= 4 {
        at[i] = half[i] * unit(next);
    }
    let target = if kind < 6 {
        // ±2ʲ units of the coordinates' rounding, j < 13.
        let place = place(axes, offset, at);
        let far = 2.0 * T::ROUNDING.into() * place.iter().fold(0.0f64, |a, x| a.max(x.abs()));
        place.map(|x| x + far * unit(next) * 2f64.powf(13.0 * unit(next).abs()))
    } else {
        let mut to = [0; 3].map(|_| unit(next));
        if kind == 6 {
            // Nearly along a wall.
            to[i] *= T::ROUNDING.into() * 2f64.powf(20.0 * unit(next).abs());
        }
        let to = place(axes, [0.0; 3], to);
        core::array::from_fn(|k| p[k].into() + to[k])
    };
    let to: [f64; 3] = core::array::from_fn(|k| target[k] - p[k].into());
    let length = to.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 {
        v(&to.map(|x| x / length))
    } else {
        v(&axes[0])
    }
}

/// Rays of `paths` paths in one room that left it, or led to a point that is not inside.
fn leaks<T: Number>(which: usize, paths: u32, vertex: Vertex<T>) -> u64 {
    let room_of = ROOMS[which];
    let (tilt, offset, half) = room_of;
    let scene = room::<T>(tilt, offset, half);
    let of_path = |sample: u32| {
        let place = Place {
            pixel: which as u32,
            sample,
            seed: 0,
        };
        let mut p = v(&offset);
        assert!(is_inside(&scene, p));
        let mut leaks = 0;
        for bounce in 0..PATH {
            let mut no_meter = ();
            let mut rng = Stream::new(place, bounce, Effect::Camera, 0, &mut no_meter);
            let direction = aimed(room_of, p, &mut rng);
            let ray = Ray {
                origin: p,
                direction,
            };
            let hit = nearest(&scene, &ray);
            let next = (hit.target != Target::NONE).then(|| vertex(&scene, &ray, hit));
            match next.filter(|&next| is_inside(&scene, next)) {
                Some(inside) => p = inside,
                None => {
                    leaks += 1;
                    p = v(&offset);
                }
            }
        }
        leaks
    };
    (0..paths).into_par_iter().map(of_path).sum()
}

fn all_rooms<T: Number>(paths: u32) {
    for (which, room) in ROOMS.iter().enumerate() {
        assert_eq!(leaks::<T>(which, paths, kept), 0, "{room:?}");
    }
}

#[test]
fn rays_into_corners_stay_inside() {
    struct Rays;
    impl NumberVisitor for Rays {
        fn number<T: Number>(&mut self) {
            all_rooms::<T>(1 << 9);
        }
    }
    all_rooms::<f32>(1 << 11);
    every_number(&mut Rays);
    // Planted: origins as far off a wall as a constant, and on it.
    let constant: Vertex<f32> = |scene, ray, hit| {
        let (at, normal) = (ray.at(hit.t), scene.surface(ray, hit).expect("a plate").1);
        at.along(normal, 1e-4)
    };
    let none: Vertex<f32> = |_, ray, hit| ray.at(hit.t);
    for planted in [constant, none] {
        assert!(leaks(1, 1 << 7, planted) > 0);
    }
}

/// 1.8·10⁸ rays in f32, the end of each held against six planes: 1.1·10⁹ signs.
#[test]
#[ignore = "1.8·10⁸ rays, a minute: cargo test --release -p shade --test shade -- --ignored"]
fn a_billion_signs_at_corners_are_right() {
    all_rooms::<f32>(30_000_000 / PATH);
    all_rooms::<f64>(1 << 16);
}
