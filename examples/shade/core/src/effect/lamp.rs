//! Spherical lights: soft shadows by two strategies.

use crate::path::{Path, Vertex};
use crate::scalar::{one, zero};
use crate::vector::{dim, plus, tint};
use crate::{Effect, Effects, Meter, Number, Ray, Rgb, Sampling, Sphere, Stream, Target, Vector};
use coslobe::{CosSin, balance_heuristic, power_heuristic};

/// A sphere that shines.
#[derive(Clone, Copy, Debug)]
pub struct Lamp<V: Vector> {
    /// Where it is.
    pub shape: Sphere<V>,
    /// Its radiance.
    pub radiance: Rgb<V::T>,
}

/// How what is sampled towards a lamp and what meets it by scattering are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combine {
    /// Each by its share of the densities.
    Balance,
    /// By the squares of the densities.
    Power,
    /// Only what is sampled towards the lamp.
    Light,
    /// Only what meets it by scattering.
    Scatter,
}

impl Combine {
    /// Weight of a sample of density `own` towards the lamp, where scattering has `other`.
    #[inline(always)]
    fn sampled<T: Number>(self, own: T, other: T) -> T {
        match self {
            Combine::Balance => balance_heuristic(own, other),
            Combine::Power => power_heuristic(own, other),
            Combine::Light => T::ONE,
            Combine::Scatter => T::ZERO,
        }
    }

    /// Weight of a ray of density `own` that met a lamp; one that was not scattered comes with ∞.
    #[inline(always)]
    fn met<T: Number>(self, own: T, other: T) -> T {
        match self {
            Combine::Balance => balance_heuristic(own, other),
            Combine::Power => power_heuristic(own, other),
            Combine::Light if own < T::INFINITY => T::ZERO,
            _ => T::ONE,
        }
    }
}

impl<V: Vector> Lamp<V> {
    /// No light of no size.
    pub fn neutral() -> Self {
        Lamp {
            shape: Sphere {
                centre: V::from_fn(|_| zero()),
                radius: zero(),
                material: 0,
            },
            radiance: [zero(); 3],
        }
    }

    /// (vector to the centre, its square, sin² of half the angle that the lamp fills).
    #[inline(always)]
    fn seen_from(&self, p: V) -> (V, V::T, V::T) {
        let to = self.shape.centre.sub(p);
        let square = to.dot(to);
        (to, square, self.shape.radius * self.shape.radius / square)
    }

    /// What counts of its radiance for a ray drawn with `density` that met it.
    #[inline(always)]
    pub(crate) fn met(&self, combine: Combine, ray: &Ray<V>, density: V::T) -> Rgb<V::T> {
        let (to, square, s2) = self.seen_from(ray.origin);
        let other = if s2 < one() {
            V::cone_density(s2, to.dot(ray.direction) / square.root())
        } else {
            zero()
        };
        dim(self.radiance, combine.met(density, other))
    }
}

/// The lamps' light scattered at the vertex, as far as it is sampled: one ray a lamp.
#[inline(always)]
pub(crate) fn scattered<'s, V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'s, V, E, L, M>,
    (origin, lobe): &Vertex<'s, V>,
) -> Rgb<V::T> {
    let scene = path.scene;
    let mut light = [zero(); 3];
    for (i, lamp) in scene.lamps.iter().enumerate() {
        path.meter.run(Effect::Lamp);
        let (to, square, s2) = lamp.seen_from(*origin);
        // From within there is no cone; nor where the distance is 0 and s2 NaN.
        if !(s2 < one()) || scene.combine == Combine::Scatter {
            continue;
        }
        let distance = square.root();
        let axis = to.scale(one::<V::T>() / distance);
        let (part, bounce) = (i as u32, path.bounce);
        let mut words = Stream::new(path.place, bounce, Effect::Lamp, part, path.meter);
        let (at, own) = V::cone(s2, &mut words);
        let direction = axis.around(at, &mut words);
        let Some((reflected, density)) = lobe.towards(path.law, direction) else {
            continue;
        };
        // The very edge of flatland's half turn, which has no measure.
        if !(own > zero()) {
            continue;
        }
        let ray = Ray {
            origin: *origin,
            direction,
        };
        path.meter.ray(Effect::Lamp);
        let t = near_side(lamp, distance, at);
        if !scene.is_clear(path.e, &ray, t, Target::lamp(i)) {
            continue;
        }
        let share = scene.combine.sampled(own, density);
        let arriving = tint(reflected, dim(lamp.radiance, share / own));
        light = plus(light, scene.fog.veil(path.e, &ray, t, arriving));
    }
    light
}

/// Distance of the lamp's surface at the angle `at` from its centre's direction.
#[inline(always)]
fn near_side<V: Vector>(lamp: &Lamp<V>, distance: V::T, at: CosSin<V::T>) -> V::T {
    let across = distance * at.sin;
    let square = lamp.shape.radius * lamp.shape.radius - across * across;
    let half = if square > zero() {
        square.root()
    } else {
        zero()
    };
    distance * at.cos - half
}
