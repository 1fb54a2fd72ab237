//! What a scene holds, and which effects it calls for.

use crate::effect::{Combine, Fog, Lamp, Sky, Sun};
use crate::geometry::size;
use crate::scalar::zero;
use crate::{Effect, Effects, Hit, Material, Plate, Ray, Rgb, Set, Sphere, Target, Vector};
use heapless::Vec;

/// Where the image is taken from.
#[derive(Clone, Copy, Debug)]
pub struct Camera<V: Vector> {
    /// The eye; in flatland the centre of the view.
    pub eye: V,
    /// Unit vector to the image's right.
    pub right: V,
    /// Unit vector to its top.
    pub up: V,
    /// Unit vector into the image (space alone).
    pub forward: V,
    /// Side of a pixel: at distance 1 in space, in the plane itself in flatland.
    pub step: V::T,
    /// Pixels.
    pub width: u16,
    /// Pixels.
    pub height: u16,
    /// Width of the pixel filter, a box, in pixels; 0: the centre alone.
    pub filter: V::T,
    /// Radius of the lens; 0: a pinhole.
    pub lens: V::T,
    /// Distance of the plane in focus.
    pub focus: V::T,
}

/// A scene.
#[derive(Clone, Debug)]
pub struct Scene<V: Vector> {
    /// Where the image is taken from.
    pub camera: Camera<V>,
    /// Spheres.
    pub spheres: Vec<Sphere<V>, 32>,
    /// Plates.
    pub plates: Vec<Plate<V>, 16>,
    /// Materials.
    pub materials: Vec<Material<V>, 16>,
    /// Spherical lights.
    pub lamps: Vec<Lamp<V>, 4>,
    /// Light of the environment.
    pub sky: Sky<V::T>,
    /// The light at infinity.
    pub sun: Sun<V>,
    /// Fog within a sphere.
    pub fog: Fog<V>,
    /// Most scatterings of a path.
    pub bounces: u16,
    /// How a lamp's two strategies are combined.
    pub combine: Combine,
    /// The frame's seed.
    pub seed: u32,
}

impl<V: Vector> Scene<V> {
    /// An empty scene: black, and every effect neutral.
    pub fn new(camera: Camera<V>) -> Scene<V> {
        Scene {
            camera,
            spheres: Vec::new(),
            plates: Vec::new(),
            materials: Vec::new(),
            lamps: Vec::new(),
            sky: Sky::default(),
            sun: Sun::neutral(),
            fog: Fog::neutral(),
            bounces: 1,
            combine: Combine::Balance,
            seed: 0,
        }
    }

    /// The effects that the scene calls for: those that could change a pixel.
    pub fn called_for(&self) -> Set {
        let zero = zero();
        let some = |c: &Rgb<V::T>| c.iter().any(|x| *x > zero);
        let any = |f: &dyn Fn(&Material<V>) -> bool| {
            let spheres = self.spheres.iter().map(|s| s.material);
            let mut used = spheres.chain(self.plates.iter().map(|p| p.material));
            used.any(|i| self.materials.get(usize::from(i)).is_some_and(f))
        };
        let fog = self.fog.region.radius > zero;
        let may_scatter = self.bounces > 0;
        let diffuse = may_scatter && any(&|m| m.is_diffuse);
        let gloss = may_scatter && any(&|m| m.share != 0);
        let scatters_fog = fog && self.fog.scattering > zero;
        let scattering = may_scatter && scatters_fog;
        let scatters = diffuse || gloss || scattering;
        Set::LEAST
            .with_if(Effect::Filter, self.camera.filter > zero)
            .with_if(Effect::Lens, self.camera.lens > zero)
            .with_if(Effect::Sky, some(&self.sky.nadir) || some(&self.sky.zenith))
            .with_if(Effect::Emission, any(&|m| some(&m.emission)))
            .with_if(
                Effect::Sun,
                some(&self.sun.irradiance) && (scatters || V::DIM == 2),
            )
            .with_if(Effect::Lamp, !self.lamps.is_empty())
            .with_if(Effect::Diffuse, diffuse)
            .with_if(Effect::Gloss, gloss)
            .with_if(Effect::Mix, may_scatter && any(&Material::is_mixed))
            .with_if(Effect::Bounces, self.bounces > 1 && scatters)
            .with_if(
                Effect::Absorption,
                // Without scatterings to follow, what fog scatters is as good as absorbed.
                fog && some(&self.fog.absorption) || scatters_fog && !may_scatter,
            )
            .with_if(Effect::Scattering, scattering)
    }

    /// What the ray meets first. Lamps are looked for where they are on.
    #[inline(always)]
    pub(crate) fn nearest<E: Effects>(&self, e: E, ray: &Ray<V>) -> Hit<V::T> {
        let mut hit = Hit::nothing();
        for (i, sphere) in self.spheres.iter().enumerate() {
            hit.nearer(sphere.hit(ray), Target::sphere(i));
        }
        for (i, plate) in self.plates.iter().enumerate() {
            hit.nearer(plate.hit(ray), Target::plate(i));
        }
        if e.on(Effect::Lamp) {
            for (i, lamp) in self.lamps.iter().enumerate() {
                hit.nearer(lamp.shape.hit(ray), Target::lamp(i));
            }
        }
        hit
    }

    /// Whether nothing but `except` lies within `t`.
    #[inline(always)]
    pub(crate) fn is_clear<E: Effects>(&self, e: E, ray: &Ray<V>, t: V::T, except: Target) -> bool {
        if self.spheres.iter().any(|sphere| sphere.hit(ray) < t)
            || self.plates.iter().any(|plate| plate.hit(ray) < t)
        {
            return false;
        }
        if e.on(Effect::Lamp) {
            for (i, lamp) in self.lamps.iter().enumerate() {
                if except != Target::lamp(i) && lamp.shape.hit(ray) < t {
                    return false;
                }
            }
        }
        true
    }

    /// The material of a sphere or plate.
    #[inline(always)]
    pub fn material(&self, target: Target) -> Option<&Material<V>> {
        let i = target.index();
        let material = if target.is_plate() {
            self.plates.get(i)?.material
        } else {
            self.spheres.get(i)?.material
        };
        self.materials.get(usize::from(material))
    }

    /// (the point, the unit normal) of a sphere or plate that was hit, both on the side that the
    /// ray comes from: the point lies off the surface as far as rounding reaches, and is
    /// [`kept`](Scene::kept).
    #[inline(always)]
    pub fn surface(&self, ray: &Ray<V>, hit: Hit<V::T>) -> Option<(V, V)> {
        let p = ray.at(hit.t);
        let i = hit.target.index();
        let (p, normal) = if hit.target.is_plate() {
            self.plates.get(i)?.vertex(ray.origin, p)
        } else {
            self.spheres.get(i)?.vertex(ray, p)
        };
        Some((self.kept(ray.origin, p, hit.target), normal))
    }

    /// A point that a ray from `from` led to, on the same side as `from` of all that it did not
    /// pass: what is so near that rounding may have taken the point through it pushes it back. `of`
    /// has done so already.
    #[inline(always)]
    pub fn kept(&self, from: V, mut p: V, mut of: Target) -> V {
        let size = size(from, p);
        // In a sharp corner one push may undo another; each round leaves less of that, and these
        // are enough down to corners of 5°.
        for _ in 0..16 {
            let mut is_done = true;
            for (i, plate) in self.plates.iter().enumerate() {
                if of == Target::plate(i) {
                    continue;
                }
                if let Some(kept) = plate.kept(from, p, size) {
                    (p, is_done) = (kept, false);
                }
            }
            for (i, sphere) in self.spheres.iter().enumerate() {
                if of == Target::sphere(i) {
                    continue;
                }
                if let Some(kept) = sphere.kept(from, p, size) {
                    (p, is_done) = (kept, false);
                }
            }
            if is_done {
                break;
            }
            of = Target::NONE;
        }
        p
    }
}
