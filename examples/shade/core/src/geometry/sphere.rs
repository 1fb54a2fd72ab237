//! Spheres; in flatland circles.

use super::{Ray, pushed, reach, reaches, size, sum};
use crate::scalar::{abs, half, infinity, least, one, zero};
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
    /// Square of half the chord (≤ 0: missed) of a line at `to` from the centre, nearest to it at
    /// `middle`.
    #[inline(always)]
    fn chord(&self, to: V, direction: V, middle: V::T) -> V::T {
        let across = to.along(direction, -middle);
        self.radius * self.radius - across.dot(across)
    }

    /// (distance from the centre)² − radius²: positive outside.
    #[inline(always)]
    fn power(&self, to: V) -> V::T {
        to.dot(to) - self.radius * self.radius
    }

    /// Distance of the first hit, ∞ for none.
    ///
    /// Which root it is depends on nothing but the side that the ray starts on: from outside the
    /// nearer one, if the ray comes closer at all, and from within the farther one, always.
    #[inline(always)]
    pub fn hit(&self, ray: &Ray<V>) -> V::T {
        let none = infinity();
        let to = self.centre.sub(ray.origin);
        let (middle, power) = (to.dot(ray.direction), self.power(to));
        let outside = power > zero();
        if outside && !(middle > zero()) {
            return none;
        }
        let square = self.chord(to, ray.direction, middle);
        if outside {
            // Not middle − √square, which near the sphere could be negative.
            return if square > zero() {
                power / (middle + square.root())
            } else {
                none
            };
        }
        let chord = if square > zero() {
            square.root()
        } else {
            zero()
        };
        let far = middle + chord;
        if far > zero() { far } else { zero() }
    }

    /// (the point that `ray` met, put on the sphere and then off it, the unit normal on the side
    /// that the ray comes from).
    #[inline(always)]
    pub(crate) fn vertex(&self, ray: &Ray<V>, p: V) -> (V, V) {
        let out = p.sub(self.centre);
        let square = out.dot(out);
        // A sphere smaller than the grid of numbers at its place may be its centre and nothing
        // else.
        let normal = if square > zero() {
            out.scale(one::<V::T>() / square.root())
        } else {
            ray.direction.scale(-one::<V::T>())
        };
        let (at, outside) = self.off(normal, ray.origin, size(ray.origin, p));
        (
            at,
            if outside {
                normal
            } else {
                normal.scale(-one::<V::T>())
            },
        )
    }

    /// (the point off the sphere in the direction `normal` from its centre, whether `from` is
    /// outside).
    #[inline(always)]
    fn off(&self, normal: V, from: V, size: V) -> (V, bool) {
        let reach = reach(normal, self.centre, size) + reaches::<V::T>() * self.radius;
        let off = reach + reach;
        let outside = self.power(self.centre.sub(from)) > zero();
        let at = if outside {
            self.radius + off
        } else {
            self.radius - least(off, self.radius * half())
        };
        (self.centre.along(normal, at), outside)
    }

    /// `p` kept on the side that `from` is on, if it is so near that rounding may have taken it to
    /// the other.
    #[inline(always)]
    pub(crate) fn kept(&self, from: V, p: V, size: V) -> Option<V> {
        let out = p.sub(self.centre);
        let square = out.dot(out);
        let radius = self.radius;
        let most = pushed(reaches::<V::T>() * (sum(self.centre) + sum(size) + radius));
        let power = square - radius * radius;
        if !(abs(power) < most * (radius + radius + most) && square > zero()) {
            return None;
        }
        let distance = square.root();
        let normal = out.scale(one::<V::T>() / distance);
        let reach = reach(normal, self.centre, size) + reaches::<V::T>() * radius;
        let outside = self.power(self.centre.sub(from)) > zero();
        let height = if outside {
            distance - radius
        } else {
            radius - distance
        };
        (height < reach && height > -pushed(reach)).then(|| self.off(normal, from, size).0)
    }

    /// Where the ray enters (≥ 0), and the length up to `t` within.
    #[inline(always)]
    pub fn span(&self, ray: &Ray<V>, t: V::T) -> (V::T, V::T) {
        let to = self.centre.sub(ray.origin);
        let middle = to.dot(ray.direction);
        let square = self.chord(to, ray.direction, middle);
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
