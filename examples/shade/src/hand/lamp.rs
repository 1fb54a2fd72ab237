//! Surfaces under one spherical lamp.

use super::open_sky::diffuse;
use super::{filtered, is_clear, nearest, pinhole, plus, surface, words};
use coslobe::{CosSin, Lambert, Law, Sample, balance_heuristic};
use shade_core::{Effect, Place, Ray, Scene, Target, Vector};

type Space = Scene<[f32; 3]>;

/// How a diffuse surface reflects to a direction, with Lambert's density of it.
#[inline(always)]
pub(super) fn lambertian(
    normal: [f32; 3],
    albedo: [f32; 3],
) -> impl Fn([f32; 3]) -> Option<([f32; 3], f32)> {
    move |d| {
        let cos = normal.dot(d);
        let p = Lambert.density(CosSin { cos, sin: 0.0 });
        (cos > 0.0).then(|| (albedo.map(|a| a * p), p))
    }
}

/// What the lamp sends to a surface directly.
#[inline(always)]
pub(super) fn direct<V: Vector<T = f32>>(
    scene: &Scene<V>,
    origin: V,
    reflected: impl Fn(V) -> Option<([f32; 3], f32)>,
    (place, bounce): (Place, u32),
) -> [f32; 3] {
    let (black, lamp) = ([0.0; 3], &scene.lamps[0]);
    let to = lamp.shape.centre.sub(origin);
    let square = to.dot(to);
    let s2 = lamp.shape.radius * lamp.shape.radius / square;
    if !(s2 < 1.0) {
        return black;
    }
    let distance = libm::sqrtf(square);
    let axis = to.scale(1.0 / distance);
    let mut no_meter = ();
    let mut words = words(place, bounce, Effect::Lamp, &mut no_meter);
    let (at, own) = V::cone(s2, &mut words);
    let direction = axis.around(at, &mut words);
    let Some((reflected, p)) = reflected(direction) else {
        return black;
    };
    if !(own > 0.0) {
        return black;
    }
    let across = distance * at.sin;
    let half = lamp.shape.radius * lamp.shape.radius - across * across;
    let t = distance * at.cos - if half > 0.0 { libm::sqrtf(half) } else { 0.0 };
    let shadow = Ray { origin, direction };
    if !is_clear(scene, &shadow, t) {
        return black;
    }
    let k = balance_heuristic(own, p) / own;
    core::array::from_fn(|i| reflected[i] * (lamp.radiance[i] * k))
}

/// What the lamp counts, if the ray meets it before `t`.
#[inline(always)]
pub(super) fn met<V: Vector<T = f32>>(
    scene: &Scene<V>,
    ray: &Ray<V>,
    t: f32,
    density: f32,
) -> Option<[f32; 3]> {
    let lamp = &scene.lamps[0];
    if !(lamp.shape.hit(ray) < t) {
        return None;
    }
    let to = lamp.shape.centre.sub(ray.origin);
    let square = to.dot(to);
    let s2 = lamp.shape.radius * lamp.shape.radius / square;
    let other = if s2 < 1.0 {
        V::cone_density(s2, to.dot(ray.direction) / libm::sqrtf(square))
    } else {
        0.0
    };
    let share = balance_heuristic(density, other);
    Some(lamp.radiance.map(|x| x * share))
}

#[inline(always)]
fn bounces(scene: &Space, at: (u16, u16), place: Place, limit: u32) -> [f32; 3] {
    let mut ray = pinhole(scene, filtered(scene, at, place));
    let (mut light, mut throughput, mut density) = ([0.0; 3], [1.0; 3], f32::INFINITY);
    for bounce in 0..=limit {
        let hit = nearest(scene, &ray);
        if let Some(shine) = met(scene, &ray, hit.t, density) {
            return plus(light, throughput, shine);
        }
        if hit.target == Target::NONE || bounce == limit {
            break;
        }
        let Some((origin, normal, material)) = surface(scene, &ray, hit) else {
            break;
        };
        let shine = direct(
            scene,
            origin,
            lambertian(normal, material.diffuse),
            (place, bounce),
        );
        light = plus(light, throughput, shine);
        let direction;
        Sample {
            direction,
            density,
            ..
        } = diffuse(normal, place, bounce);
        throughput = core::array::from_fn(|i| throughput[i] * material.diffuse[i]);
        ray = Ray { origin, direction };
    }
    light
}

#[inline(always)]
pub fn soft_shadow(scene: &Space, at: (u16, u16), place: Place) -> [f32; 3] {
    bounces(scene, at, place, 1)
}

#[inline(always)]
pub fn interior(scene: &Space, at: (u16, u16), place: Place) -> [f32; 3] {
    bounces(scene, at, place, u32::from(scene.bounces))
}
