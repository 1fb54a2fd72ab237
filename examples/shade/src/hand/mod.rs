//! Shaders written by hand, each for one scene, as one would without effects and plans: `coslobe`'s
//! laws, the core's shapes and random words, and no more. Tests ask them for the same bits as the
//! core's.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // NaN goes the same way as what fails

mod depth_of_field;
mod emitter;
mod flat;
mod fog;
mod gloss;
mod hard_shadow;
mod lamp;
mod open_sky;

pub use depth_of_field::depth_of_field;
pub use emitter::emitter;
pub use flat::{flat_bounces, flat_lamp};
pub use fog::fog;
pub use gloss::gloss;
pub use hard_shadow::hard_shadow;
pub use lamp::{interior, soft_shadow};
pub use open_sky::{furnace, gradient};

use coslobe::rand_core::Rng;
use shade_core::{Effect, Hit, Material, Place, Ray, Scene, Stream, Target, Vector};

/// The words of an effect.
#[inline(always)]
fn words(place: Place, bounce: u32, effect: Effect, meter: &mut ()) -> Stream<'_, ()> {
    Stream::new(place, bounce, effect, 0, meter)
}

/// The pixel's middle in the image plane.
#[inline(always)]
fn middle<V: Vector<T = f32>>(scene: &Scene<V>, (x, y): (u16, u16)) -> (f32, f32) {
    let from_middle =
        |at: u16, size: u16| f32::from((2 * i32::from(at) + 1 - i32::from(size)) as i16) * 0.5;
    (
        from_middle(x, scene.camera.width),
        from_middle(y, scene.camera.height),
    )
}

/// A point of the pixel in the image plane.
#[inline(always)]
fn filtered<V: Vector<T = f32>>(scene: &Scene<V>, at: (u16, u16), place: Place) -> (f32, f32) {
    let word = words(place, 0, Effect::Filter, &mut ()).next_u32();
    let part = |n: u32| (f32::from(n as u16 as i16) + 0.5) * (1.0 / 65536.0) * scene.camera.filter;
    let (x, y) = middle(scene, at);
    (x + part(word), y + part(word >> 16))
}

/// The pinhole's ray.
#[inline(always)]
fn pinhole(scene: &Scene<[f32; 3]>, (x, y): (f32, f32)) -> Ray<[f32; 3]> {
    let camera = &scene.camera;
    let (x, y) = (x * camera.step, -(y * camera.step));
    Ray {
        origin: camera.eye,
        direction: camera
            .forward
            .along(camera.right, x)
            .along(camera.up, y)
            .unit(),
    }
}

/// The nearest sphere or plate.
#[inline(always)]
fn nearest<V: Vector<T = f32>>(scene: &Scene<V>, ray: &Ray<V>) -> Hit<f32> {
    let mut hit = Hit::nothing();
    for (i, sphere) in scene.spheres.iter().enumerate() {
        hit.nearer(sphere.hit(ray), Target::sphere(i));
    }
    for (i, plate) in scene.plates.iter().enumerate() {
        hit.nearer(plate.hit(ray), Target::plate(i));
    }
    hit
}

/// Whether no sphere or plate is nearer than `t`.
#[inline(always)]
fn is_clear<V: Vector<T = f32>>(scene: &Scene<V>, ray: &Ray<V>, t: f32) -> bool {
    scene.spheres.iter().all(|sphere| !(sphere.hit(ray) < t))
        && scene.plates.iter().all(|plate| !(plate.hit(ray) < t))
}

/// (the point, the normal on the side that is seen, the material) of what was hit.
#[inline(always)]
fn surface<'s, V: Vector<T = f32>>(
    scene: &'s Scene<V>,
    ray: &Ray<V>,
    hit: Hit<f32>,
) -> Option<(V, V, &'s Material<V>)> {
    let material = scene.material(hit.target)?;
    let (p, normal) = scene.surface(ray, hit)?;
    Some((p, normal, material))
}

/// a + b·c.
#[inline(always)]
fn plus(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> [f32; 3] {
    core::array::from_fn(|i| a[i] + b[i] * c[i])
}
