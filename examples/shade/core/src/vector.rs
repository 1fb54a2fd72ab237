//! Vectors of space and of flatland, and what differs between the two worlds.

use crate::law::Sampling;
use crate::laws::{AnyPlanar, AnySpatial};
use crate::scalar::one;
use crate::{Number, Rgb};
use coslobe::rand_core::Rng;
use coslobe::{CircleShell, CosSin, Frame, Lambert, Law, uniform};

/// `[T; 3]` for space, `[T; 2]` for flatland.
///
/// In flatland light travels in a plane: radiance is per radian, Lambert's law is cos θ / 2, a
/// sphere is a circle and a rectangle a segment. A pixel is a point of that plane, and its value
/// the mean of the radiance that arrives there from all around.
pub trait Vector: Copy + Send + Sync + core::fmt::Debug + 'static {
    /// The number type.
    type T: Number;
    /// Any law of this world, chosen at run time.
    type Law: Sampling<Self>;
    /// Number of components.
    const DIM: usize;

    /// Component by component.
    fn from_fn(f: impl FnMut(usize) -> Self::T) -> Self;
    /// The i-th component.
    fn at(&self, i: usize) -> Self::T;
    /// self · b.
    fn dot(self, b: Self) -> Self::T;

    /// Density of a direction uniform all around.
    fn isotropic_density() -> Self::T;
    /// A direction uniform all around.
    fn isotropic<R: Rng>(rng: &mut R) -> Self;
    /// The world direction at (cos θ, sin θ) from a unit axis, azimuth drawn where there is one.
    fn around<R: Rng>(self, at: CosSin<Self::T>, rng: &mut R) -> Self;

    /// Density of light reflected by a white diffuse surface, f·cos θ: cos θ/π or cos θ/2.
    fn diffuse_density(cos: Self::T) -> Self::T;
    /// (cos θ, sin θ, density) of a direction towards a sphere seen under sin² of its half angle =
    /// `s2`: by solid angle in space, by the sine in flatland, which needs no arcsine.
    fn cone<R: Rng>(s2: Self::T, rng: &mut R) -> (CosSin<Self::T>, Self::T);
    /// Density of [`cone`](Vector::cone) at cos θ.
    fn cone_density(s2: Self::T, cos: Self::T) -> Self::T;

    /// self + b.
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Self::from_fn(|i| self.at(i) + b.at(i))
    }
    /// self − b.
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Self::from_fn(|i| self.at(i) - b.at(i))
    }
    /// self · k.
    #[inline(always)]
    fn scale(self, k: Self::T) -> Self {
        Self::from_fn(|i| self.at(i) * k)
    }
    /// self + d·k.
    #[inline(always)]
    fn along(self, d: Self, k: Self::T) -> Self {
        Self::from_fn(|i| self.at(i) + d.at(i) * k)
    }
    /// self/|self|.
    #[inline(always)]
    fn unit(self) -> Self {
        self.scale(one::<Self::T>() / self.dot(self).root())
    }
    /// A direction that was drawn, as a unit vector.
    #[inline(always)]
    fn drawn(self) -> Self {
        if Self::T::IS_COARSE {
            self.unit()
        } else {
            self
        }
    }
    /// The height of a direction, which skies are graded by.
    #[inline(always)]
    fn up(self) -> Self::T {
        self.at(1)
    }
    /// (cos, sin) of the angle of the unit vector `d` from the unit vector `self`, 0 ≤ sin.
    #[inline(always)]
    fn angle_to(self, d: Self) -> CosSin<Self::T> {
        let cos = self.dot(d);
        let across = d.along(self, -cos);
        CosSin {
            cos,
            sin: across.dot(across).root(),
        }
    }
}

impl<T: Number> Vector for [T; 3] {
    type T = T;
    type Law = AnySpatial<T>;
    const DIM: usize = 3;

    #[inline(always)]
    fn from_fn(f: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(f)
    }
    #[inline(always)]
    fn at(&self, i: usize) -> T {
        self[i]
    }
    #[inline(always)]
    fn dot(self, b: Self) -> T {
        self[0] * b[0] + self[1] * b[1] + self[2] * b[2]
    }
    #[inline(always)]
    fn isotropic_density() -> T {
        T::QUARTER / T::PI
    }
    /// cos θ = 1 − 2u and sin θ = 2√(u(1−u)), both exact at both poles.
    #[inline(always)]
    fn isotropic<R: Rng>(rng: &mut R) -> Self {
        let u = uniform::tails::<T, _>(rng);
        let azimuth = uniform::azimuth::<T, _>(rng);
        let sin = T::int(2) * (u.lower() * u.upper()).root();
        [sin * azimuth.cos, u.upper() - u.lower(), sin * azimuth.sin].drawn()
    }
    #[inline(always)]
    fn around<R: Rng>(self, at: CosSin<T>, rng: &mut R) -> Self {
        let azimuth = uniform::azimuth::<T, _>(rng);
        let local = [at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin];
        Frame::from_unit(self).to_world(local).drawn()
    }
    #[inline(always)]
    fn diffuse_density(cos: T) -> T {
        Lambert.density(CosSin { cos, sin: T::ZERO })
    }
    #[inline(always)]
    fn cone<R: Rng>(s2: T, rng: &mut R) -> (CosSin<T>, T) {
        let height = cap(s2);
        // 1 − cos θ, from which the sine of a narrow cone keeps its digits.
        let depth = uniform::tails::<T, _>(rng).lower() * height;
        let at = CosSin {
            cos: T::ONE - depth,
            sin: (depth * (T::int(2) - depth)).root(),
        };
        (at, T::ONE / (T::int(2) * T::PI * height))
    }
    #[inline(always)]
    fn cone_density(s2: T, _: T) -> T {
        T::ONE / (T::int(2) * T::PI * cap(s2))
    }
}

/// 1 − cos α from sin²α, without cancellation.
#[inline(always)]
fn cap<T: Number>(s2: T) -> T {
    s2 / (T::ONE + (T::ONE - s2).root())
}

impl<T: Number> Vector for [T; 2] {
    type T = T;
    type Law = AnyPlanar;
    const DIM: usize = 2;

    #[inline(always)]
    fn from_fn(f: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(f)
    }
    #[inline(always)]
    fn at(&self, i: usize) -> T {
        self[i]
    }
    #[inline(always)]
    fn dot(self, b: Self) -> T {
        self[0] * b[0] + self[1] * b[1]
    }
    #[inline(always)]
    fn isotropic_density() -> T {
        T::HALF / T::PI
    }
    #[inline(always)]
    fn isotropic<R: Rng>(rng: &mut R) -> Self {
        let turn = uniform::azimuth::<T, _>(rng);
        [turn.cos, turn.sin].drawn()
    }
    #[inline(always)]
    fn around<R: Rng>(self, at: CosSin<T>, _: &mut R) -> Self {
        let [x, y] = self;
        [x * at.cos + y * at.sin, y * at.cos - x * at.sin].drawn()
    }
    #[inline(always)]
    fn diffuse_density(cos: T) -> T {
        CircleShell.density(CosSin { cos, sin: T::ZERO })
    }
    /// sin θ = s(2u − 1): the flat Lambert law, of which the circle covers the middle.
    #[inline(always)]
    fn cone<R: Rng>(s2: T, rng: &mut R) -> (CosSin<T>, T) {
        let s = s2.root();
        let u = uniform::tails::<T, _>(rng);
        let sin = s * (u.lower() - u.upper());
        // Rounding may take the sine of nearly a half turn beyond 1.
        let square = (T::ONE - sin) * (T::ONE + sin);
        let cos = if square > T::ZERO {
            square.root()
        } else {
            T::ZERO
        };
        (CosSin { cos, sin }, Self::cone_density(s2, cos))
    }
    #[inline(always)]
    fn cone_density(s2: T, cos: T) -> T {
        // Nor does a ray that met the sphere lean away from it, but for rounding.
        let cos = if cos > T::ZERO { cos } else { T::ZERO };
        cos / (T::int(2) * s2.root())
    }
}

/// a · b, colour by colour.
#[inline(always)]
pub(crate) fn tint<T: Number>(a: Rgb<T>, b: Rgb<T>) -> Rgb<T> {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// a · k.
#[inline(always)]
pub(crate) fn dim<T: Number>(a: Rgb<T>, k: T) -> Rgb<T> {
    a.map(|x| x * k)
}

/// a + b.
#[inline(always)]
pub(crate) fn plus<T: Number>(a: Rgb<T>, b: Rgb<T>) -> Rgb<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
