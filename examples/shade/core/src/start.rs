//! Where a path starts: at the camera, or in flatland at a probe of the light.

use crate::effect::{Lobe, isotropic, through_lens, through_pixel};
use crate::number::{half, int};
use crate::path::Path;
use crate::{Effect, Effects, Meter, Ray, Sampling, Target, Vector};

/// The first ray.
#[inline(always)]
pub(crate) fn start<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'_, V, E, L, M>,
    (x, y): (u16, u16),
) -> Ray<V> {
    path.meter.run(Effect::Camera);
    path.meter.ray(Effect::Camera);
    let camera = &path.scene.camera;
    let middle = |at: u16, size: u16| {
        let pixels = int::<V::T>((2 * i32::from(at) + 1 - i32::from(size)) as i16);
        pixels * half()
    };
    let (mut x, mut y) = (middle(x, camera.width), middle(y, camera.height));
    if path.e.on(Effect::Filter) {
        let [dx, dy] = through_pixel(camera, path.place, path.meter);
        (x, y) = (x + dx, y + dy);
    }
    let (x, y) = (x * camera.step, -(y * camera.step));
    if V::DIM == 2 {
        return probe(path, camera.eye.along(camera.right, x).along(camera.up, y));
    }
    let ray = |origin: V, x, y| Ray {
        origin,
        direction: camera
            .forward
            .along(camera.right, x)
            .along(camera.up, y)
            .unit(),
        from: Target::NONE,
    };
    if path.e.on(Effect::Lens) {
        // All rays of a pixel meet in the plane of focus; with a radius of 0 they are the pinhole's.
        let [u, v] = through_lens::<V, M>(path.place, path.meter);
        let slope = camera.lens / camera.focus;
        let eye = camera.eye.along(camera.right, u * camera.lens);
        let eye = eye.along(camera.up, v * camera.lens);
        ray(eye, x - u * slope, y - v * slope)
    } else {
        ray(camera.eye, x, y)
    }
}

/// The mean radiance at a point: it scatters to all sides what arrives there.
#[inline(always)]
fn probe<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'_, V, E, L, M>,
    point: V,
) -> Ray<V> {
    path.direct(&(point, Target::NONE, Lobe::Isotropic));
    let onward = isotropic(Effect::Camera, path.place, 0, path.meter);
    path.bounce = 1;
    path.follow(onward, point, Target::NONE)
}
