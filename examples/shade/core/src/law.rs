//! The crate's laws as the shader uses them: to draw a direction around an axis, and its density
//! there.

use crate::scalar::zero;
use crate::{Number, Vector};
use core::fmt::Debug;
use coslobe::rand_core::Rng;
use coslobe::{CosSin, Law, Planar, Spatial, uniform};

/// A law that draws directions around an axis in the world of `V`.
pub trait Sampling<V: Vector>: Copy + Send + Sync + Debug {
    /// The direction, (cos θ, sin θ) and the density, rad⁻¹ or sr⁻¹: those of the angle that was
    /// drawn.
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
    /// Its samples split a word, which is another in each number type. By its warp all types draw
    /// the same directions, so that their pictures can be compared.
    const SPLITS: bool = false;
}

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
