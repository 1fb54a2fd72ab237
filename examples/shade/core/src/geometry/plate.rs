//! Rectangles; in flatland segments.

use super::Ray;
use crate::Vector;
use crate::number::{abs, infinity, zero};

/// A rectangle or segment, seen from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Plate<V: Vector> {
    /// Its centre.
    pub centre: V,
    /// A unit vector across it.
    pub normal: V,
    /// Unit vectors along its sides; the second counts in space alone.
    pub axes: [V; 2],
    /// Half the length of each side; ∞ for a plane.
    pub half: [V::T; 2],
    /// Which material.
    pub material: u8,
}

impl<V: Vector> Plate<V> {
    /// Distance of the hit, ∞ for none.
    #[inline(always)]
    pub fn hit(&self, ray: &Ray<V>) -> V::T {
        let none = infinity();
        let to = self.centre.sub(ray.origin);
        let t = to.dot(self.normal) / ray.direction.dot(self.normal);
        // False for NaN too: a ray along the plate.
        if !(t > zero() && t < none) {
            return none;
        }
        let from_centre = ray.direction.scale(t).sub(to);
        for i in 0..V::DIM - 1 {
            // False for NaN too.
            if !(abs(from_centre.dot(self.axes[i])) <= self.half[i]) {
                return none;
            }
        }
        t
    }

    /// A point brought back onto the plate's plane.
    #[inline(always)]
    pub(crate) fn onto(&self, p: V) -> V {
        p.along(self.normal, self.centre.sub(p).dot(self.normal))
    }
}
