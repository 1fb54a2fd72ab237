//! What the atlas asks of a law, whatever its type.

use crate::number::Number;
use crate::random::Counter;
use crate::reference::Shape;
use coslobe::{CosSin, Moments, Planar, Spatial};
use std::f64::consts::TAU;

/// What the atlas asks of a law in one number type.
pub(crate) trait Probe<T>: Sync {
    fn draw(&self, rng: &mut Counter) -> CosSin<f64>;
    /// cos θ where the tail of the horizon is p.
    fn cos_at(&self, p: T) -> T;
    /// Density of θ alone, per radian.
    fn marginal(&self, theta: T) -> f64;
    /// Density of the direction: per radian in the plane, per steradian in space.
    fn lobe(&self, theta: T) -> T;
    fn moments(&self) -> Moments<T>;
}

/// A law of the plane.
pub(crate) struct Flat<L>(pub(crate) L);
/// A law of space.
pub(crate) struct Solid<L>(pub(crate) L);

impl<T: Number, L: Planar<T> + Sync> Probe<T> for Flat<L> {
    fn draw(&self, rng: &mut Counter) -> CosSin<f64> {
        let [sin, cos] = self.0.sample(rng).map(Into::into);
        CosSin { cos, sin }
    }

    fn cos_at(&self, p: T) -> T {
        self.0.warp(p).cos
    }

    fn marginal(&self, theta: T) -> f64 {
        self.0.pdf(theta).into()
    }

    fn lobe(&self, theta: T) -> T {
        self.0.pdf(theta)
    }

    fn moments(&self) -> Moments<T> {
        self.0.moments()
    }
}

impl<T: Number, L: Spatial<T> + Sync> Probe<T> for Solid<L> {
    fn draw(&self, rng: &mut Counter) -> CosSin<f64> {
        let [x, cos, z] = self.0.sample(rng).map(Into::into);
        let sin = f64::hypot(x, z);
        CosSin { cos, sin }
    }

    fn cos_at(&self, p: T) -> T {
        self.0.warp_sf(p).cos
    }

    fn marginal(&self, theta: T) -> f64 {
        TAU * self.0.pdf(theta).into()
    }

    fn lobe(&self, theta: T) -> T {
        self.0.pdf_solid_angle(theta)
    }

    fn moments(&self) -> Moments<T> {
        self.0.moments()
    }
}

/// One number type's side of a law.
pub(crate) struct Side<T> {
    pub(crate) probe: Box<dyn Probe<T>>,
    pub(crate) shape: Shape,
}

/// A law in a number type.
pub(crate) fn side<T>(probe: impl Probe<T> + 'static, shape: Shape) -> Side<T> {
    Side {
        probe: Box::new(probe),
        shape,
    }
}
