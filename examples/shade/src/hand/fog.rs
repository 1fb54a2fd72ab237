//! Diffuse surfaces and fog in the sun, several bounces.

use super::lamp::lambertian;
use super::open_sky::diffuse;
use super::{filtered, is_clear, nearest, pinhole, plus, surface, words};
use coslobe::uniform;
use shade_core::{Effect, Place, Ray, Scene, Target, Vector};

type Space = Scene<[f32; 3]>;

/// `light` that comes to `origin` from the sun.
#[inline(always)]
fn sunlight(scene: &Space, origin: [f32; 3], reflected: [f32; 3]) -> [f32; 3] {
    let ray = Ray {
        origin,
        direction: scene.sun.towards,
    };
    if !is_clear(scene, &ray, f32::INFINITY) {
        return [0.0; 3];
    }
    let fog = &scene.fog;
    let length = fog.region.span(&ray, f32::INFINITY).1;
    core::array::from_fn(|i| {
        let fade = libm::expf(-((fog.absorption[i] + fog.scattering) * length));
        reflected[i] * scene.sun.irradiance[i] * fade
    })
}

#[inline(always)]
pub fn fog(scene: &Space, at: (u16, u16), place: Place) -> [f32; 3] {
    let mut ray = pinhole(scene, filtered(scene, at, place));
    let (mut light, mut throughput) = ([0.0; 3], [1.0; 3]);
    let fog = &scene.fog;
    // The last of the bounces meets nothing: no light is to be met by chance.
    for bounce in 0..u32::from(scene.bounces) {
        let is_last = bounce + 1 == u32::from(scene.bounces);
        let hit = nearest(scene, &ray);
        let (near, length) = fog.region.span(&ray, hit.t);
        let mut no_meter = ();
        let mut distance = words(place, bounce, Effect::Scattering, &mut no_meter);
        let depth = -libm::logf(uniform::tails::<f32, _>(&mut distance).lower());
        let is_scattered = depth < fog.scattering * length;
        let length = if is_scattered {
            depth / fog.scattering
        } else {
            length
        };
        throughput =
            core::array::from_fn(|i| throughput[i] * libm::expf(-(fog.absorption[i] * length)));
        if is_scattered {
            let p = <[f32; 3]>::isotropic_density();
            let at = ray.at(near + length);
            let origin = scene.kept(ray.origin, at, Target::NONE);
            light = plus(light, throughput, sunlight(scene, origin, [p; 3]));
            if is_last {
                break;
            }
            let mut words =
                shade_core::Stream::new(place, bounce, Effect::Scattering, 1, &mut no_meter);
            ray = Ray {
                origin,
                direction: Vector::isotropic(&mut words),
            };
            continue;
        }
        let Some((origin, normal, material)) = surface(scene, &ray, hit) else {
            break;
        };
        if let Some((reflected, _)) = lambertian(normal, material.diffuse)(scene.sun.towards) {
            light = plus(light, throughput, sunlight(scene, origin, reflected));
        }
        if is_last {
            break;
        }
        throughput = core::array::from_fn(|i| throughput[i] * material.diffuse[i]);
        ray = Ray {
            origin,
            direction: diffuse(normal, place, bounce).direction,
        };
    }
    light
}
