//! The integrator: one path, and of each effect only what is on.

use crate::effect::{Diffuse, Gloss, Lobe, Onward, isotropic, lamp, scattered_at, sun};
use crate::scalar::{abs, infinity, one, zero};
use crate::start::{Aim, start};
use crate::vector::{plus, tint};
use crate::{Effect, Effects, Hit, Meter, Place, Ray, Rgb, Sampling, Scene, Target, Vector};

/// A path on its way.
pub(crate) struct Path<'s, V: Vector, E, L, M> {
    pub(crate) scene: &'s Scene<V>,
    pub(crate) e: E,
    pub(crate) law: &'s L,
    pub(crate) place: Place,
    pub(crate) meter: &'s mut M,
    /// What it has gathered.
    pub(crate) light: Rgb<V::T>,
    /// What counts of what it meets from here on.
    pub(crate) throughput: Rgb<V::T>,
    /// Which random words are next.
    pub(crate) bounce: u32,
    /// Density with which the ray's direction was drawn; ∞ for a ray from the camera.
    pub(crate) density: V::T,
}

/// Where a path is scattered, and how.
pub(crate) type Vertex<'s, V> = (V, Lobe<'s, V>);

/// Radiance of one sample of a pixel.
///
/// A path is followed from the camera to at most `scene.bounces` scatterings. At each, sun and
/// lamps are asked for their light directly; sky and emitters are met by the path itself, and lamps
/// by both. Its last ray is traced only if there is something that it could meet.
#[inline(always)]
pub fn radiance<V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    scene: &Scene<V>,
    e: E,
    law: &L,
    aim: &Aim<V>,
    place: Place,
    meter: &mut M,
) -> Rgb<V::T> {
    let mut path = Path {
        scene,
        e,
        law,
        place,
        meter,
        light: [zero(); 3],
        throughput: [one(); 3],
        bounce: 0,
        density: infinity(),
    };
    let (mut ray, mut hit) = start(&mut path, aim);
    if e.on(Effect::Bounces) {
        let mut left = scene.bounces;
        while let Some(next) = path.segment(&ray, hit, left) {
            ray = next;
            hit = scene.nearest(e, &ray);
            left -= 1;
        }
    } else if e.on(Effect::Diffuse) || e.on(Effect::Gloss) || e.on(Effect::Scattering) {
        if let Some(ray) = path.segment(&ray, hit, 1) {
            path.segment(&ray, scene.nearest(e, &ray), 0);
        }
    } else {
        path.segment(&ray, hit, 0);
    }
    path.light
}

impl<'s, V: Vector, E: Effects, L: Sampling<V>, M: Meter> Path<'s, V, E, L, M> {
    /// Follows the ray to where it is scattered, of which there are `left`, and returns the ray
    /// that goes on.
    #[inline(always)]
    fn segment(&mut self, ray: &Ray<V>, hit: Hit<V::T>, left: u16) -> Option<Ray<V>> {
        let e = self.e;
        let vertex = match self.through_fog(ray, hit.t, left == 0) {
            Some(vertex) => vertex,
            None => self.arrive(ray, hit, left == 0)?,
        };
        self.direct(&vertex);
        let meets_light = e.on(Effect::Sky) || e.on(Effect::Emission) || e.on(Effect::Lamp);
        if left == 1 && !meets_light {
            return None;
        }
        self.onward(&vertex)
    }

    /// Fog up to `t`: what it takes of the light, and where it scatters.
    #[inline(always)]
    fn through_fog(&mut self, ray: &Ray<V>, t: V::T, is_last: bool) -> Option<Vertex<'s, V>> {
        let (absorbs, scatters) = (self.e.on(Effect::Absorption), self.e.on(Effect::Scattering));
        if !absorbs && !scatters {
            return None;
        }
        let fog = &self.scene.fog;
        let (near, length) = fog.region.span(ray, t);
        if is_last || !scatters {
            // Nothing scatters it any more: what fog takes is known.
            self.meter.run(Effect::Absorption);
            self.throughput = fog.faded(length, self.throughput);
            return None;
        }
        let at = scattered_at(fog, length, self.place, self.bounce, self.meter);
        if absorbs {
            self.meter.run(Effect::Absorption);
            self.throughput = fog.absorbed(at.unwrap_or(length), self.throughput);
        }
        at.map(|at| {
            let at = ray.at(near + at);
            let at = self.scene.kept(ray.origin, at, Target::NONE);
            (at, Lobe::Isotropic)
        })
    }

    /// What the ray met: its light, and how it is scattered there.
    #[inline(always)]
    fn arrive(&mut self, ray: &Ray<V>, hit: Hit<V::T>, is_last: bool) -> Option<Vertex<'s, V>> {
        if hit.target == Target::NONE {
            if self.e.on(Effect::Sky) {
                self.meter.run(Effect::Sky);
                self.gather(self.scene.sky.radiance(ray.direction));
            }
            return None;
        }
        if self.e.on(Effect::Lamp) && hit.target.is_lamp() {
            let lamp = self.scene.lamps.get(hit.target.index())?;
            self.gather(lamp.met(self.scene.combine, ray, self.density));
            return None;
        }
        let material = self.scene.material(hit.target)?;
        if self.e.on(Effect::Emission) {
            self.meter.run(Effect::Emission);
            self.gather(material.emission);
        }
        if is_last || !(self.e.on(Effect::Diffuse) || self.e.on(Effect::Gloss)) {
            return None;
        }
        let (position, normal) = self.scene.surface(ray, hit)?;
        let is_glossy = self.e.on(Effect::Gloss)
            && if self.e.on(Effect::Mix) {
                material.chooses_gloss(self.place, self.bounce, self.meter)
            } else {
                material.share != 0
            };
        let lobe = if is_glossy {
            let cos = normal.dot(ray.direction);
            Lobe::Gloss(Gloss {
                normal,
                mirror: ray.direction.along(normal, abs(cos + cos)),
                material,
            })
        } else if self.e.on(Effect::Diffuse) && material.is_diffuse {
            Lobe::Diffuse(Diffuse {
                normal,
                albedo: material.diffuse,
            })
        } else {
            return None;
        };
        Some((position, lobe))
    }

    /// The light that sun and lamps send to the vertex directly.
    #[inline(always)]
    pub(crate) fn direct(&mut self, vertex: &Vertex<'s, V>) {
        if self.e.on(Effect::Sun) {
            let light = sun::scattered(self, vertex);
            self.gather(light);
        }
        if self.e.on(Effect::Lamp) {
            let light = lamp::scattered(self, vertex);
            self.gather(light);
        }
    }

    /// The ray that goes on from the vertex.
    #[inline(always)]
    fn onward(&mut self, (position, lobe): &Vertex<'s, V>) -> Option<Ray<V>> {
        let with_density = self.e.on(Effect::Lamp);
        let (place, bounce) = (self.place, self.bounce);
        let onward = match lobe {
            Lobe::Gloss(lobe) if self.e.on(Effect::Gloss) => {
                lobe.onward(with_density, place, bounce, self.meter)?
            }
            Lobe::Diffuse(lobe) if self.e.on(Effect::Diffuse) => {
                lobe.onward(self.law, with_density, place, bounce, self.meter)
            }
            _ => isotropic(Effect::Scattering, place, bounce, self.meter),
        };
        self.bounce += 1;
        Some(self.follow(onward, *position))
    }

    #[inline(always)]
    pub(crate) fn follow(&mut self, onward: Onward<V>, origin: V) -> Ray<V> {
        self.throughput = tint(self.throughput, onward.weight);
        self.density = onward.density;
        Ray {
            origin,
            direction: onward.direction,
        }
    }

    #[inline(always)]
    fn gather(&mut self, light: Rgb<V::T>) {
        self.light = plus(self.light, tint(self.throughput, light));
    }
}
