//! The crate's laws as the shader uses them: to draw a direction around an axis, and its density there.

use crate::number::zero;
use crate::{Number, Vector};
use core::fmt::Debug;
use coslobe::rand_core::Rng;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Lambert, Law, Planar, Spatial,
    SphereShell, uniform,
};

/// A law that draws directions around an axis in the world of `V`.
pub trait Sampling<V: Vector>: Copy + Send + Sync + Debug {
    /// The direction, (cos θ, sin θ) and the density, rad⁻¹ or sr⁻¹: those of the angle that was drawn.
    fn draw<R: Rng>(&self, axis: V, rng: &mut R) -> (V, CosSin<V::T>, V::T);
    /// Density of the direction `d` around `axis`.
    fn density_of(&self, axis: V, d: V) -> V::T;
    /// What a sample weighs for a white diffuse surface.
    fn diffuse_weight(&self, at: CosSin<V::T>) -> V::T;
    /// ⟨cos θ⟩.
    fn mean_cos(&self) -> V::T;
}

/// What is known of a law before it is called.
pub trait Reads {
    /// Its density reads the sine.
    const SINE: bool = false;
    /// It is the law of diffuse reflection itself, whose samples all weigh 1.
    const DIFFUSE: bool = false;
    /// Its samples split a word, each number type in a way of its own. By its warp all types draw the same
    /// directions, so that their pictures can be compared.
    const SPLITS: bool = false;
}

impl Reads for Lambert {
    const DIFFUSE: bool = true;
}
impl Reads for SphereShell {
    const SPLITS: bool = true;
}
impl Reads for Ball {}
impl<T: Number> Reads for CosPower<T> {
    const SINE: bool = true;
}
impl Reads for CircleShell {
    const DIFFUSE: bool = true;
}
impl Reads for Disk {
    const SPLITS: bool = true;
}
impl Reads for CircleArc {}

/// The pair of `d` around `axis`, as far as the law `L` reads it.
#[inline(always)]
fn pair<L: Reads, V: Vector>(axis: V, d: V) -> CosSin<V::T> {
    if L::SINE {
        axis.angle_to(d)
    } else {
        CosSin {
            cos: axis.dot(d),
            sin: zero(),
        }
    }
}

#[inline(always)]
fn warped<L: Law<V::T>, V: Vector, R: Rng>(
    law: &L,
    axis: V,
    rng: &mut R,
) -> (V, CosSin<V::T>, V::T) {
    let at = law.warp_tails(uniform::tails::<V::T, _>(rng));
    (axis.around(at, rng), at, law.density(at))
}

impl<T: Number, L: Spatial<T> + Reads + Copy + Send + Sync + Debug> Sampling<[T; 3]> for L {
    #[inline(always)]
    fn draw<R: Rng>(&self, axis: [T; 3], rng: &mut R) -> ([T; 3], CosSin<T>, T) {
        if L::SPLITS {
            return warped(self, axis, rng);
        }
        let s = self.sample_around_with_density(axis, rng);
        (s.direction.drawn(), s.at, s.density)
    }
    #[inline(always)]
    fn density_of(&self, axis: [T; 3], d: [T; 3]) -> T {
        self.density(pair::<L, _>(axis, d))
    }
    #[inline(always)]
    fn diffuse_weight(&self, at: CosSin<T>) -> T {
        if L::DIFFUSE {
            T::ONE
        } else {
            self.lambert_weight(at)
        }
    }
    fn mean_cos(&self) -> T {
        self.moments().mean_cos
    }
}

impl<T: Number, L: Planar<T> + Reads + Copy + Send + Sync + Debug> Sampling<[T; 2]> for L {
    #[inline(always)]
    fn draw<R: Rng>(&self, axis: [T; 2], rng: &mut R) -> ([T; 2], CosSin<T>, T) {
        if L::SPLITS {
            return warped(self, axis, rng);
        }
        let s = self.sample_with_density(rng);
        (axis.around(s.at, rng), s.at, s.density)
    }
    #[inline(always)]
    fn density_of(&self, axis: [T; 2], d: [T; 2]) -> T {
        self.density(pair::<L, _>(axis, d))
    }
    #[inline(always)]
    fn diffuse_weight(&self, at: CosSin<T>) -> T {
        if L::DIFFUSE {
            T::ONE
        } else {
            self.lambert_weight(at)
        }
    }
    fn mean_cos(&self) -> T {
        self.moments().mean_cos
    }
}

/// Any law of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnySpatial<T: Number> {
    /// cos θ.
    Lambert,
    /// cos²θ.
    SphereShell,
    /// cos³θ.
    Ball,
    /// cosᵏθ.
    Power(CosPower<T>),
}

/// Any law of flatland.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyPlanar {
    /// 1.
    CircleArc,
    /// cos θ.
    CircleShell,
    /// cos²θ.
    Disk,
}

/// Each call is passed on to the law.
impl<T: Number> Sampling<[T; 3]> for AnySpatial<T> {
    #[inline(always)]
    fn draw<R: Rng>(&self, axis: [T; 3], rng: &mut R) -> ([T; 3], CosSin<T>, T) {
        match self {
            Self::Lambert => Lambert.draw(axis, rng),
            Self::SphereShell => SphereShell.draw(axis, rng),
            Self::Ball => Ball.draw(axis, rng),
            Self::Power(law) => law.draw(axis, rng),
        }
    }
    #[inline(always)]
    fn density_of(&self, axis: [T; 3], d: [T; 3]) -> T {
        match self {
            Self::Lambert => Lambert.density_of(axis, d),
            Self::SphereShell => SphereShell.density_of(axis, d),
            Self::Ball => Ball.density_of(axis, d),
            Self::Power(law) => law.density_of(axis, d),
        }
    }
    #[inline(always)]
    fn diffuse_weight(&self, at: CosSin<T>) -> T {
        match self {
            Self::Lambert => Lambert.lambert_weight(at),
            Self::SphereShell => SphereShell.lambert_weight(at),
            Self::Ball => Ball.lambert_weight(at),
            Self::Power(law) => law.lambert_weight(at),
        }
    }
    fn mean_cos(&self) -> T {
        match self {
            Self::Lambert => Lambert.mean_cos(),
            Self::SphereShell => SphereShell.mean_cos(),
            Self::Ball => Ball.mean_cos(),
            Self::Power(law) => law.mean_cos(),
        }
    }
}

impl<T: Number> Sampling<[T; 2]> for AnyPlanar {
    #[inline(always)]
    fn draw<R: Rng>(&self, axis: [T; 2], rng: &mut R) -> ([T; 2], CosSin<T>, T) {
        match self {
            Self::CircleArc => CircleArc.draw(axis, rng),
            Self::CircleShell => CircleShell.draw(axis, rng),
            Self::Disk => Disk.draw(axis, rng),
        }
    }
    #[inline(always)]
    fn density_of(&self, axis: [T; 2], d: [T; 2]) -> T {
        match self {
            Self::CircleArc => CircleArc.density_of(axis, d),
            Self::CircleShell => CircleShell.density_of(axis, d),
            Self::Disk => Disk.density_of(axis, d),
        }
    }
    #[inline(always)]
    fn diffuse_weight(&self, at: CosSin<T>) -> T {
        match self {
            Self::CircleArc => CircleArc.lambert_weight(at),
            Self::CircleShell => CircleShell.lambert_weight(at),
            Self::Disk => Disk.lambert_weight(at),
        }
    }
    fn mean_cos(&self) -> T {
        match self {
            Self::CircleArc => Sampling::<[T; 2]>::mean_cos(&CircleArc),
            Self::CircleShell => Sampling::<[T; 2]>::mean_cos(&CircleShell),
            Self::Disk => Sampling::<[T; 2]>::mean_cos(&Disk),
        }
    }
}
