//! Where a path starts: at the camera, or in flatland at a probe of the light.

use crate::effect::{Lobe, isotropic, through_lens, through_pixel};
use crate::path::Path;
use crate::scalar::{half, int};
use crate::{Camera, Effect, Effects, Hit, Meter, Ray, Sampling, Scene, Vector};

/// What all samples of a pixel have in common.
#[derive(Clone, Copy, Debug)]
pub struct Aim<V: Vector> {
    /// The pixel's middle, in pixels from the image's.
    x: V::T,
    y: V::T,
    /// The ray through it and what it meets, where there is neither filter nor lens.
    ray: Ray<V>,
    hit: Hit<V::T>,
}

/// Whether all samples of a pixel start with the same ray.
#[inline(always)]
fn is_still<V: Vector, E: Effects>(e: E) -> bool {
    V::DIM == 3 && !e.on(Effect::Filter) && !e.on(Effect::Lens)
}

impl<V: Vector> Aim<V> {
    /// At the pixel (x, y).
    #[inline(always)]
    pub fn new<E: Effects, M: Meter>(
        scene: &Scene<V>,
        e: E,
        (x, y): (u16, u16),
        meter: &mut M,
    ) -> Self {
        let camera = &scene.camera;
        let middle = |at: u16, size: u16| {
            let pixels = int::<V::T>((2 * i32::from(at) + 1 - i32::from(size)) as i16);
            pixels * half()
        };
        let (x, y) = (middle(x, camera.width), middle(y, camera.height));
        let (right, up) = (x * camera.step, -(y * camera.step));
        let ray = ray(camera, camera.eye, right, up);
        let hit = if is_still::<V, E>(e) {
            meter.run(Effect::Camera);
            meter.ray(Effect::Camera);
            scene.nearest(e, &ray)
        } else {
            Hit::nothing()
        };
        Aim { x, y, ray, hit }
    }
}

#[inline(always)]
fn ray<V: Vector>(camera: &Camera<V>, origin: V, right: V::T, up: V::T) -> Ray<V> {
    let direction = camera.forward.along(camera.right, right);
    Ray {
        origin,
        direction: direction.along(camera.up, up).unit(),
    }
}

/// The first ray, and what it meets.
#[inline(always)]
pub(crate) fn start<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'_, V, E, L, M>,
    aim: &Aim<V>,
) -> (Ray<V>, Hit<V::T>) {
    if is_still::<V, E>(path.e) {
        return (aim.ray, aim.hit);
    }
    path.meter.run(Effect::Camera);
    path.meter.ray(Effect::Camera);
    let ray = first(path, aim);
    (ray, path.scene.nearest(path.e, &ray))
}

#[inline(always)]
fn first<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'_, V, E, L, M>,
    aim: &Aim<V>,
) -> Ray<V> {
    let camera = &path.scene.camera;
    let (mut x, mut y) = (aim.x, aim.y);
    if path.e.on(Effect::Filter) {
        let [dx, dy] = through_pixel(camera, path.place, path.meter);
        (x, y) = (x + dx, y + dy);
    }
    let (x, y) = (x * camera.step, -(y * camera.step));
    if V::DIM == 2 {
        let point = camera.eye.along(camera.right, x).along(camera.up, y);
        return probe(path, point);
    }
    if path.e.on(Effect::Lens) {
        // All rays of a pixel meet in the plane of focus; with a radius of 0 they are the
        // pinhole's.
        let [u, v] = through_lens::<V, M>(path.place, path.meter);
        let slope = camera.lens / camera.focus;
        let eye = camera.eye.along(camera.right, u * camera.lens);
        let eye = eye.along(camera.up, v * camera.lens);
        ray(camera, eye, x - u * slope, y - v * slope)
    } else {
        ray(camera, camera.eye, x, y)
    }
}

/// The mean radiance at a point: it scatters to all sides what arrives there.
#[inline(always)]
fn probe<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'_, V, E, L, M>,
    point: V,
) -> Ray<V> {
    path.direct(&(point, Lobe::Isotropic));
    let onward = isotropic(Effect::Camera, path.place, 0, path.meter);
    path.bounce = 1;
    path.follow(onward, point)
}
