//! Flatland: a probe of the light at each pixel.

use super::lamp::{direct, met};
use super::open_sky::sky;
use super::{filtered, is_clear, nearest, plus, surface, words};
use coslobe::{CircleShell, CosSin, Law, Planar};
use shade_core::{Effect, Place, Ray, Sampling, Scene, Stream, Target, Vector};

type Flat = Scene<[f32; 2]>;

fn point(scene: &Flat, at: (u16, u16), place: Place) -> [f32; 2] {
    let camera = &scene.camera;
    let (x, y) = filtered(scene, at, place);
    let (x, y) = (x * camera.step, -(y * camera.step));
    camera.eye.along(camera.right, x).along(camera.up, y)
}

/// Around a probe: equally to all sides.
#[inline(always)]
fn around(origin: [f32; 2], place: Place) -> Ray<[f32; 2]> {
    Ray {
        origin,
        direction: Vector::isotropic(&mut Stream::new(place, 0, Effect::Camera, 1, &mut ())),
    }
}

/// How a diffuse segment reflects to a direction, with its density.
#[inline(always)]
fn lambertian(normal: [f32; 2], albedo: [f32; 3]) -> impl Fn([f32; 2]) -> Option<([f32; 3], f32)> {
    move |d| {
        let cos = normal.dot(d);
        let p = CircleShell.density(CosSin { cos, sin: 0.0 });
        (cos > 0.0).then(|| (albedo.map(|a| a * p), p))
    }
}

/// (a direction, its density) by the flat Lambert law.
#[inline(always)]
fn diffuse(normal: [f32; 2], place: Place, bounce: u32) -> ([f32; 2], f32) {
    let mut no_meter = ();
    let mut words = words(place, bounce, Effect::Diffuse, &mut no_meter);
    let s = Planar::<f32>::sample_with_density(&CircleShell, &mut words);
    (normal.around(s.at, &mut words), s.density)
}

#[inline(always)]
pub fn flat_lamp(scene: &Flat, at: (u16, u16), place: Place) -> [f32; 3] {
    let p = <[f32; 2]>::isotropic_density();
    let probe = point(scene, at, place);
    let mut light = direct(scene, probe, |_| Some(([p; 3], p)), (place, 0));
    let ray = around(probe, place);
    let hit = nearest(scene, &ray);
    if let Some(shine) = met(scene, &ray, hit.t, p) {
        return plus(light, [1.0; 3], shine);
    }
    if hit.target == Target::NONE {
        return light;
    }
    let Some((origin, normal, material)) = surface(scene, &ray, hit) else {
        return light;
    };
    let reflected = lambertian(normal, material.diffuse);
    let shine = direct(scene, origin, reflected, (place, 1));
    light = plus(light, [1.0; 3], shine);
    let (direction, density) = diffuse(normal, place, 1);
    let on = Ray { origin, direction };
    let next = nearest(scene, &on);
    match met(scene, &on, next.t, density) {
        Some(shine) => plus(light, material.diffuse, shine),
        None => light,
    }
}

/// `light` that comes to `origin` from the sun.
#[inline(always)]
fn sunlight(scene: &Flat, origin: [f32; 2], reflected: Option<[f32; 3]>) -> [f32; 3] {
    let Some(reflected) = reflected else {
        return [0.0; 3];
    };
    let ray = Ray {
        origin,
        direction: scene.sun.towards,
    };
    if is_clear(scene, &ray, f32::INFINITY) {
        core::array::from_fn(|i| reflected[i] * scene.sun.irradiance[i])
    } else {
        [0.0; 3]
    }
}

#[inline(always)]
pub fn flat_bounces(scene: &Flat, at: (u16, u16), place: Place) -> [f32; 3] {
    let probe = point(scene, at, place);
    let p = <[f32; 2]>::isotropic_density();
    let mut light = sunlight(scene, probe, Some([p; 3]));
    let (mut ray, mut throughput) = (around(probe, place), [1.0; 3]);
    let limit = u32::from(scene.bounces);
    for bounce in 1..=limit + 1 {
        let hit = nearest(scene, &ray);
        if hit.target == Target::NONE {
            return plus(light, throughput, sky(scene, ray.direction));
        }
        if bounce == limit + 1 {
            break;
        }
        let Some((origin, normal, material)) = surface(scene, &ray, hit) else {
            break;
        };
        let direction;
        if material.share != 0 {
            let cos = normal.dot(ray.direction);
            let mirror = ray.direction.along(normal, (cos + cos).abs());
            let (cos, p) = (
                normal.dot(scene.sun.towards),
                material.lobe.density_of(mirror, scene.sun.towards),
            );
            let reflected = (cos > 0.0 && p > 0.0).then(|| material.gloss.map(|r| r * (cos * p)));
            light = plus(light, throughput, sunlight(scene, origin, reflected));
            let mut no_meter = ();
            let mut words = words(place, bounce, Effect::Gloss, &mut no_meter);
            (direction, ..) = Sampling::<[f32; 2]>::draw(&material.lobe, mirror, &mut words);
            let cos = normal.dot(direction);
            if !(cos > 0.0) {
                break;
            }
            throughput = core::array::from_fn(|i| throughput[i] * (material.gloss[i] * cos));
        } else {
            let reflected = lambertian(normal, material.diffuse)(scene.sun.towards).map(|r| r.0);
            light = plus(light, throughput, sunlight(scene, origin, reflected));
            (direction, _) = diffuse(normal, place, bounce);
            throughput = core::array::from_fn(|i| throughput[i] * material.diffuse[i]);
        }
        ray = Ray { origin, direction };
    }
    light
}
