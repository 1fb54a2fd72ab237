//! The sun on diffuse surfaces.

use super::{filtered, is_clear, nearest, pinhole, surface};
use coslobe::{CosSin, Lambert, Law};
use shade_core::{Place, Ray, Scene, Target};

#[inline(always)]
pub fn hard_shadow(scene: &Scene<[f32; 3]>, at: (u16, u16), place: Place) -> [f32; 3] {
    let black = [0.0; 3];
    let ray = pinhole(scene, filtered(scene, at, place));
    let hit = nearest(scene, &ray);
    if hit.target == Target::NONE {
        return black;
    }
    let Some((origin, normal, material)) = surface(scene, &ray, hit) else {
        return black;
    };
    let direction = scene.sun.towards;
    let cos = normal[0] * direction[0] + normal[1] * direction[1] + normal[2] * direction[2];
    if !(cos > 0.0) {
        return black;
    }
    let shadow = Ray { origin, direction };
    if !is_clear(scene, &shadow, f32::INFINITY) {
        return black;
    }
    let reflected = Lambert.density(CosSin { cos, sin: 0.0 });
    core::array::from_fn(|i| material.diffuse[i] * reflected * scene.sun.irradiance[i])
}
