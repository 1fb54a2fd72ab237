//! Emitters and a diffuse floor through a thin lens, one bounce.

use super::open_sky::{diffuse, sky};
use super::{filtered, nearest, plus, surface, words};
use coslobe::Lambert;
use shade_core::{Effect, Place, Ray, Scene, Target, Vector};

#[inline(always)]
pub fn depth_of_field(scene: &Scene<[f32; 3]>, at: (u16, u16), place: Place) -> [f32; 3] {
    let camera = &scene.camera;
    let (x, y) = filtered(scene, at, place);
    let (x, y) = (x * camera.step, -(y * camera.step));
    let [u, _, v]: [f32; 3] = Lambert.sample(&mut words(place, 0, Effect::Lens, &mut ()));
    let slope = camera.lens / camera.focus;
    let (x, y) = (x - u * slope, y - v * slope);
    let eye = camera.eye.along(camera.right, u * camera.lens);
    let direction = camera.forward.along(camera.right, x);
    let ray = Ray {
        origin: eye.along(camera.up, v * camera.lens),
        direction: direction.along(camera.up, y).unit(),
    };
    let hit = nearest(scene, &ray);
    if hit.target == Target::NONE {
        return sky(scene, ray.direction);
    }
    let Some(material) = scene.material(hit.target) else {
        return [0.0; 3];
    };
    let light = material.emission;
    if !material.is_diffuse {
        return light;
    }
    let Some((origin, normal, _)) = surface(scene, &ray, hit) else {
        return light;
    };
    let on = Ray {
        origin,
        direction: diffuse(normal, place, 0).direction,
    };
    let met = nearest(scene, &on);
    let shine = if met.target == Target::NONE {
        sky(scene, on.direction)
    } else {
        scene.material(met.target).map_or([0.0; 3], |m| m.emission)
    };
    plus(light, material.diffuse, shine)
}
