//! Rays and the shapes that they meet.

mod plate;
mod sphere;

pub use plate::Plate;
pub use sphere::Sphere;

use crate::{Number, Vector};

/// What a ray met or leaves: an index over spheres, plates and lamps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target(pub u16);

impl Target {
    /// Nothing.
    pub const NONE: Target = Target(u16::MAX);
    const PLATES: u16 = 1 << 8;
    const LAMPS: u16 = 1 << 9;

    /// A sphere.
    #[inline(always)]
    pub fn sphere(i: usize) -> Target {
        Target(i as u16)
    }
    /// A plate.
    #[inline(always)]
    pub fn plate(i: usize) -> Target {
        Target(Self::PLATES | i as u16)
    }
    #[inline(always)]
    pub(crate) fn lamp(i: usize) -> Target {
        Target(Self::LAMPS | i as u16)
    }
    /// Which of its kind.
    #[inline(always)]
    pub(crate) fn index(self) -> usize {
        (self.0 & 0xFF) as usize
    }
    #[inline(always)]
    pub(crate) fn is_plate(self) -> bool {
        self.0 & Self::PLATES != 0
    }
    #[inline(always)]
    pub(crate) fn is_lamp(self) -> bool {
        self.0 & Self::LAMPS != 0
    }
}

/// A ray, which knows the surface that it leaves: no distance below which hits are not believed.
#[derive(Clone, Copy, Debug)]
pub struct Ray<V> {
    /// Where it starts.
    pub origin: V,
    /// A unit vector.
    pub direction: V,
    /// What it leaves.
    pub from: Target,
}

impl<V: Vector> Ray<V> {
    /// The point at distance t.
    #[inline(always)]
    pub fn at(&self, t: V::T) -> V {
        self.origin.along(self.direction, t)
    }
}

/// What a ray met first.
#[derive(Clone, Copy, Debug)]
pub struct Hit<T> {
    /// How far; ∞ for nothing.
    pub t: T,
    /// What.
    pub target: Target,
}

impl<T: Number> Hit<T> {
    /// Nothing, at ∞.
    #[inline(always)]
    pub fn nothing() -> Self {
        Hit {
            t: T::INFINITY,
            target: Target::NONE,
        }
    }
    /// Becomes what is nearer.
    #[inline(always)]
    pub fn nearer(&mut self, t: T, target: Target) {
        if t < self.t {
            *self = Hit { t, target };
        }
    }
}
