//! Rays and the shapes that they meet.

mod plate;
mod sphere;

pub use plate::Plate;
pub use sphere::Sphere;

use crate::scalar::abs;
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

/// A ray. One that leaves a surface starts as far off it as rounding can have moved its origin
/// ([`Scene::surface`](crate::Scene::surface)): no distance below which hits are not believed.
#[derive(Clone, Copy, Debug)]
pub struct Ray<V> {
    /// Where it starts.
    pub origin: V,
    /// A unit vector.
    pub direction: V,
}

/// Bounds the rounding errors of a point `p` that a ray from `origin` led to, and of whether it
/// lies before or behind a shape at `centre`, in the direction `n` from the shape.
///
/// To first order in the unit roundoff u: the distance at which the shape is met errs by 4u
/// |n|·(|centre| + |origin|) and 4u |n|·|p − origin|, the point then by 2u |n|·(|p| + |origin|),
/// its height over the shape when asked for again by 4u |n|·(|centre| + |p|), and what the
/// scene's own rounding moves two shapes apart that should touch by 2u |n|·(|centre| + |p|). All
/// together stay below 16u |n|·(|centre| + |origin| + |p|).
#[inline(always)]
fn reach<V: Vector>(n: V, centre: V, size: V) -> V::T {
    let sizes = V::from_fn(|i| abs(centre.at(i)) + size.at(i));
    V::from_fn(|i| abs(n.at(i))).dot(sizes) * reaches()
}

/// 16u.
#[inline(always)]
fn reaches<T: Number>() -> T {
    T::int(16) * T::ROUNDING
}

/// How far behind a shape a point may be that should lie before it: rounding's `reach`, and twice
/// that by which another shape has pushed it.
#[inline(always)]
fn pushed<T: Number>(reach: T) -> T {
    T::int(3) * reach
}

/// |origin| + |p|, component by component.
#[inline(always)]
pub(crate) fn size<V: Vector>(origin: V, p: V) -> V {
    V::from_fn(|i| abs(origin.at(i)) + abs(p.at(i)))
}

/// Sum of the components' sizes.
#[inline(always)]
fn sum<V: Vector>(v: V) -> V::T {
    let mut sum = abs(v.at(0));
    for i in 1..V::DIM {
        sum = sum + abs(v.at(i));
    }
    sum
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
