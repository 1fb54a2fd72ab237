//! Diffuse surfaces under a sky, one bounce.

use super::{filtered, middle, nearest, pinhole, plus, surface, words};
use coslobe::{Lambert, Sample, Spatial};
use shade_core::{Effect, Hit, Place, Ray, Scene, Target, Vector};

type Space = Scene<[f32; 3]>;

#[inline(always)]
pub(super) fn sky<V: Vector<T = f32>>(scene: &Scene<V>, d: V) -> [f32; 3] {
    let height = (1.0 + d.at(1)) * 0.5;
    let sky = &scene.sky;
    core::array::from_fn(|i| sky.nadir[i] + (sky.zenith[i] - sky.nadir[i]) * height)
}

/// A direction by Lambert's law, with its density.
#[inline(always)]
pub(super) fn diffuse(normal: [f32; 3], place: Place, bounce: u32) -> Sample<f32, 3> {
    Lambert.sample_around_with_density(normal, &mut words(place, bounce, Effect::Diffuse, &mut ()))
}

#[inline(always)]
fn one_bounce(scene: &Space, ray: &Ray<[f32; 3]>, hit: Hit<f32>, place: Place) -> [f32; 3] {
    let black = [0.0; 3];
    if hit.target == Target::NONE {
        return sky(scene, ray.direction);
    }
    let Some((origin, normal, material)) = surface(scene, ray, hit) else {
        return black;
    };
    let on = Ray {
        origin,
        direction: diffuse(normal, place, 0).direction,
    };
    if nearest(scene, &on).target == Target::NONE {
        plus(black, material.diffuse, sky(scene, on.direction))
    } else {
        black
    }
}

#[inline(always)]
pub fn furnace(scene: &Space, at: (u16, u16)) -> impl Fn(Place) -> [f32; 3] {
    // Without a filter the samples of a pixel part at the first hit.
    let ray = pinhole(scene, middle(scene, at));
    let hit = nearest(scene, &ray);
    move |place| one_bounce(scene, &ray, hit, place)
}

#[inline(always)]
pub fn gradient(scene: &Space, at: (u16, u16), place: Place) -> [f32; 3] {
    let ray = pinhole(scene, filtered(scene, at, place));
    one_bounce(scene, &ray, nearest(scene, &ray), place)
}
