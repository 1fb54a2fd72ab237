//! Spheres; in flatland circles.

use super::Ray;
use crate::number::{infinity, zero};
use crate::{Number, Vector};

/// A sphere, solid or a hollow world seen from within.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<V: Vector> {
    /// Its centre.
    pub centre: V,
    /// Its radius.
    pub radius: V::T,
    /// Which material.
    pub material: u8,
}

impl<V: Vector> Sphere<V> {
    /// Distance of the closest approach, and the square of half the chord (≤ 0: missed).
    #[inline(always)]
    fn chord(&self, ray: &Ray<V>) -> (V::T, V::T) {
        let to = self.centre.sub(ray.origin);
        let middle = to.dot(ray.direction);
        let across = to.along(ray.direction, -middle);
        (middle, self.radius * self.radius - across.dot(across))
    }

    /// Distance of the first hit, ∞ for none.
    #[inline(always)]
    pub fn hit(&self, ray: &Ray<V>) -> V::T {
        let (middle, square) = self.chord(ray);
        if !(square > zero()) {
            return infinity();
        }
        let half = square.root();
        let near = middle - half;
        let far = middle + half;
        if near > zero() {
            near
        } else if far > zero() {
            far
        } else {
            infinity()
        }
    }

    /// [`hit`](Sphere::hit) of a ray that starts on this sphere: of its two roots one is 0.
    #[inline(always)]
    pub fn hit_again(&self, ray: &Ray<V>) -> V::T {
        let middle = self.centre.sub(ray.origin).dot(ray.direction);
        if middle > zero() {
            middle + middle
        } else {
            infinity()
        }
    }

    /// Where the ray enters (≥ 0), and the length up to `t` within.
    #[inline(always)]
    pub fn span(&self, ray: &Ray<V>, t: V::T) -> (V::T, V::T) {
        let (middle, square) = self.chord(ray);
        if !(square > zero()) {
            return (zero(), zero());
        }
        let half = square.root();
        let (near, far) = (middle - half, middle + half);
        let near = if near > zero() { near } else { zero() };
        let far = if far < t { far } else { t };
        let length = far - near;
        let inside = length > zero();
        (near, if inside { length } else { zero() })
    }
}
