//! What is checked: something that draws, and says where in the law a sample lies.

use crate::arithmetic::native::float::Float;
use crate::{CosSin, Law, Planar, Real, Spatial};
use core::fmt;
use core::marker::PhantomData;
use rand_core::Rng;

/// A sampler with the law that it claims. [`InPlane`] and [`InSpace`] are the crate's own samplers;
/// implement it for yours, to judge it by a law of the crate.
pub trait Subject {
    /// What one draw gives.
    type Sample;

    /// Draws a sample.
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> Self::Sample;

    /// Where the sample lies in the law that is claimed.
    ///
    /// # Errors
    /// If the law cannot give it.
    fn place(&self, sample: &Self::Sample) -> Result<Place, Invalid>;
}

/// A sample by its probability in θ and its sector of φ: uniform, if the law is right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Place {
    /// The nearer tail of θ in units of 2⁻³¹: 0 to 2³⁰.
    pub tail: u32,
    /// Whether that is the upper one.
    pub upper: bool,
    /// Which of 16 equal sectors of φ, in any order but with halves of an octant side by side;
    /// none in the plane.
    pub sector: Option<u8>,
}

impl Place {
    /// Eighth of the cdf, 0 to 7.
    pub(super) fn eighth(self) -> u8 {
        let eighth = (self.tail >> 28).min(3) as u8;
        if self.upper { 7 - eighth } else { eighth }
    }

    /// Equal for equal samples.
    pub(super) fn fingerprint(self) -> u32 {
        let side = (self.tail << 1) | u32::from(self.upper);
        side ^ u32::from(self.sector.unwrap_or(0)).rotate_right(4)
    }
}

/// What is wrong with a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Invalid {
    /// A component is NaN or infinite.
    NotFinite,
    /// The square of its length is off 1 by more than 2⁻¹⁸ (`f32`, `Precise<f32>`), 2⁻³⁴ (`f64`,
    /// `Precise<f64>`), 2⁻²⁶ (`Fixed`), 2⁻¹² (`Fixed16`) or 2⁻¹⁰ (`Fast<f32>`).
    Length,
    /// On or below the horizon: cos θ ≤ 0.
    Support,
    /// The density there is 0, infinite or NaN.
    Density,
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Invalid::NotFinite => "has a component that is NaN or infinite",
            Invalid::Length => "is no unit vector",
            Invalid::Support => "lies on or below the horizon",
            Invalid::Density => "has no positive finite density",
        })
    }
}

/// Where a direction lies under `law`, once it is known to be one of its directions.
fn place<T: Real>(
    law: &impl Law<T>,
    at: CosSin<T>,
    square: T,
    sector: Option<u8>,
) -> Result<Place, Invalid> {
    if !square.is_finite() {
        return Err(Invalid::NotFinite);
    }
    if (square - T::ONE).abs() > T::from_base(T::UNIT_SLACK) {
        return Err(Invalid::Length);
    }
    if at.cos <= T::ZERO {
        return Err(Invalid::Support);
    }
    let density = law.density(at);
    if !(density > T::ZERO && density.is_finite()) {
        return Err(Invalid::Density);
    }
    let (p, is_lower) = law.unwarp_tails(at).nearer();
    let p = p.to_base();
    Ok(Place {
        tail: ((p + p) * T::Base::from_i32(1 << 30)).to_u32(),
        upper: is_lower == 0,
        sector,
    })
}

/// One of 16 sectors of the angle of (x, z), with no trigonometry.
pub(super) fn sector<T: Real>(x: T, z: T) -> u8 {
    let (a, b) = (x.abs(), z.abs());
    let steep = b > a;
    let (large, small) = if steep { (b, a) } else { (a, b) };
    // 169/408 = tan 22.5° to 5·10⁻⁶ relative: the halves of an octant differ by 10⁻⁵ of one.
    let outer = small * T::int(408) > large * T::int(169);
    let bit = |set, i| u8::from(set) << i;
    bit(x < T::ZERO, 3) | bit(z < T::ZERO, 2) | bit(steep, 1) | bit(outer, 0)
}

/// The crate's sampler of a law in the plane, in the number type `T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InPlane<T, L> {
    law: L,
    number: PhantomData<T>,
}

impl<T: Real, L: Planar<T>> InPlane<T, L> {
    /// The sampler of `law`.
    pub fn new(law: L) -> Self {
        let number = PhantomData;
        InPlane { law, number }
    }
}

impl<T: Real, L: Planar<T>> Subject for InPlane<T, L> {
    type Sample = [T; 2];

    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        Planar::sample(&self.law, rng)
    }

    fn place(&self, &[x, y]: &[T; 2]) -> Result<Place, Invalid> {
        let at = CosSin { cos: y, sin: x };
        place(&self.law, at, x * x + y * y, None)
    }
}

/// The crate's sampler of a law in space, in the number type `T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InSpace<T, L> {
    law: L,
    number: PhantomData<T>,
}

impl<T: Real, L: Spatial<T>> InSpace<T, L> {
    /// The sampler of `law`.
    pub fn new(law: L) -> Self {
        let number = PhantomData;
        InSpace { law, number }
    }
}

impl<T: Real, L: Spatial<T>> Subject for InSpace<T, L> {
    type Sample = [T; 3];

    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        Spatial::sample(&self.law, rng)
    }

    fn place(&self, &[x, y, z]: &[T; 3]) -> Result<Place, Invalid> {
        let sin = CosSin::hypot(x, z);
        let at = CosSin { cos: y, sin };
        let square = x * x + y * y + z * z;
        place(&self.law, at, square, Some(sector(x, z)))
    }
}
