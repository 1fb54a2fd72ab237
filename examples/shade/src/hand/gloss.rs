//! Glossy and diffuse surfaces under a lamp and a sky, two bounces.

use super::lamp::{direct, met};
use super::open_sky::{diffuse, sky};
use super::{filtered, nearest, pinhole, plus, surface, words};
use coslobe::Sample;
use shade_core::{Effect, Place, Ray, Sampling, Scene, Target, Vector};

#[inline(always)]
pub fn gloss(scene: &Scene<[f32; 3]>, at: (u16, u16), place: Place) -> [f32; 3] {
    let mut ray = pinhole(scene, filtered(scene, at, place));
    let (mut light, mut throughput, mut density) = ([0.0; 3], [1.0; 3], f32::INFINITY);
    let limit = u32::from(scene.bounces);
    for bounce in 0..=limit {
        let hit = nearest(scene, &ray);
        if let Some(shine) = met(scene, &ray, hit.t, density) {
            return plus(light, throughput, shine);
        }
        if hit.target == Target::NONE {
            return plus(light, throughput, sky(scene, ray.direction));
        }
        if bounce == limit {
            break;
        }
        let Some((origin, normal, material)) = surface(scene, &ray, hit) else {
            break;
        };
        let when = (place, bounce);
        let direction;
        if material.share != 0 {
            let cos = normal.dot(ray.direction);
            let mirror = ray.direction.along(normal, (cos + cos).abs());
            let reflected = |d: [f32; 3]| {
                let (cos, p) = (normal.dot(d), material.lobe.density_of(mirror, d));
                (cos > 0.0 && p > 0.0).then(|| (material.gloss.map(|r| r * (cos * p)), p))
            };
            light = plus(light, throughput, direct(scene, origin, reflected, when));
            let mut no_meter = ();
            let mut words = words(place, bounce, Effect::Gloss, &mut no_meter);
            (direction, _, density) = material.lobe.draw(mirror, &mut words);
            let cos = normal.dot(direction);
            if !(cos > 0.0) {
                break;
            }
            throughput = core::array::from_fn(|i| throughput[i] * (material.gloss[i] * cos));
        } else {
            let reflected = super::lamp::lambertian(normal, material.diffuse);
            light = plus(light, throughput, direct(scene, origin, reflected, when));
            Sample {
                direction,
                density,
                ..
            } = diffuse(normal, place, bounce);
            throughput = core::array::from_fn(|i| throughput[i] * material.diffuse[i]);
        }
        ray = Ray { origin, direction };
    }
    light
}
