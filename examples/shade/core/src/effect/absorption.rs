//! Fog by Beer and Lambert.

use crate::scalar::zero;
use crate::vector::tint;
use crate::{Effect, Effects, Number, Ray, Rgb, Sphere, Vector};

/// Homogeneous fog within a sphere: outside it the air is clear, so that sun and sky reach in.
///
/// Light fades by e^(−(absorption + scattering)·length). What is scattered goes equally to all
/// sides; it counts as a bounce, so single scattering is `bounces = 1`, and more bounces are
/// multiple scattering.
#[derive(Clone, Copy, Debug)]
pub struct Fog<V: Vector> {
    /// Where it is.
    pub region: Sphere<V>,
    /// Absorption per unit length.
    pub absorption: Rgb<V::T>,
    /// Scattering per unit length.
    pub scattering: V::T,
}

impl<V: Vector> Fog<V> {
    /// No fog, nowhere.
    pub fn neutral() -> Self {
        let region = Sphere {
            centre: V::from_fn(|_| zero()),
            radius: zero(),
            material: 0,
        };
        Fog {
            region,
            absorption: [zero(); 3],
            scattering: zero(),
        }
    }

    /// `light` after `length` of fog that absorbs.
    #[inline(always)]
    pub(crate) fn absorbed(&self, length: V::T, light: Rgb<V::T>) -> Rgb<V::T> {
        tint(light, self.absorption.map(|a| (-(a * length)).exp()))
    }

    /// `light` after `length` of fog that absorbs and scatters.
    #[inline(always)]
    pub(crate) fn faded(&self, length: V::T, light: Rgb<V::T>) -> Rgb<V::T> {
        let fade = |a: V::T| (-((a + self.scattering) * length)).exp();
        tint(light, self.absorption.map(fade))
    }

    /// `light` that comes along the ray from as far as `t`.
    #[inline(always)]
    pub(crate) fn veil<E: Effects>(
        &self,
        e: E,
        ray: &Ray<V>,
        t: V::T,
        light: Rgb<V::T>,
    ) -> Rgb<V::T> {
        if e.on(Effect::Absorption) || e.on(Effect::Scattering) {
            self.faded(self.region.span(ray, t).1, light)
        } else {
            light
        }
    }
}
