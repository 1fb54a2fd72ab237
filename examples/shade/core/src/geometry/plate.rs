//! Rectangles; in flatland segments.

use super::{Ray, pushed, reach, reaches, size, sum};
use crate::Vector;
use crate::scalar::{abs, copysign, infinity, least, one, zero};

/// A rectangle or segment, seen from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Plate<V: Vector> {
    /// Its centre.
    pub centre: V,
    /// A unit vector across it.
    pub normal: V,
    /// Unit vectors along its sides; the second counts in space alone.
    pub axes: [V; 2],
    /// Half the length of each side; ∞ for a plane. The second counts in space alone, and is 0 in
    /// flatland.
    pub half: [V::T; 2],
    /// Which material.
    pub material: u8,
}

impl<V: Vector> Plate<V> {
    /// Distance of the hit, ∞ for none.
    ///
    /// Where plates meet, no ray gets through: a plate reaches as far beyond its edges as rounding
    /// can have moved them or the hit, but never further than it is large.
    #[inline(always)]
    pub fn hit(&self, ray: &Ray<V>) -> V::T {
        let none = infinity();
        let to = self.centre.sub(ray.origin);
        let per_height = one::<V::T>() / ray.direction.dot(self.normal);
        let t = to.dot(self.normal) * per_height;
        // False for NaN too: a ray along the plate.
        if !(t > zero() && t < none) {
            return none;
        }
        let extent = self.half[0] + self.half[1];
        let error = reaches::<V::T>() * (t + extent + sum(self.centre));
        let slack = least(error * abs(per_height), extent);
        let from_centre = ray.direction.scale(t).sub(to);
        for i in 0..V::DIM - 1 {
            // False for NaN too.
            if !(abs(from_centre.dot(self.axes[i])) <= self.half[i] + slack) {
                return none;
            }
        }
        t
    }

    /// Height of a point, positive on the side that `from` is on, and the unit normal to that side.
    #[inline(always)]
    fn above(&self, from: V, p: V) -> (V::T, V) {
        let side = copysign(one(), from.sub(self.centre).dot(self.normal));
        let normal = self.normal.scale(side);
        (p.sub(self.centre).dot(normal), normal)
    }

    /// (the point that a ray from `from` met, put on the plate and then off it, the unit normal on
    /// the side of `from`).
    #[inline(always)]
    pub(crate) fn vertex(&self, from: V, p: V) -> (V, V) {
        let (height, normal) = self.above(from, p);
        let reach = reach(normal, self.centre, size(from, p));
        (p.along(normal, reach + reach - height), normal)
    }

    /// `p` kept on the side that `from` is on, if it is so near that rounding may have taken it to
    /// the other.
    #[inline(always)]
    pub(crate) fn kept(&self, from: V, p: V, size: V) -> Option<V> {
        let reach = reach(self.normal, self.centre, size);
        let height = p.sub(self.centre).dot(self.normal);
        if !(abs(height) < pushed(reach)) {
            return None;
        }
        let (height, normal) = self.above(from, p);
        (height < reach).then(|| p.along(normal, reach + reach - height))
    }
}
