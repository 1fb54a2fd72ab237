//! An orthonormal frame around a normal.

use crate::number::Real;
use core::fmt;

/// A right-handed orthonormal frame whose +y axis is a given normal, as the laws have their axis.
///
/// Around +y it is the identity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Frame<T> {
    tangent: [T; 3],
    normal: [T; 3],
    bitangent: [T; 3],
}

/// Why a normal was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum NormalError {
    /// A component is NaN or infinite.
    NotFinite,
    /// All components are zero.
    Zero,
    /// The length is too far from 1 for integers, which do not scale it.
    NotUnit,
}

impl fmt::Display for NormalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            NormalError::NotFinite => "the normal has a NaN or infinite component; expected finite",
            NormalError::Zero => "the normal is zero; expected a vector with a direction",
            NormalError::NotUnit => "the normal's length is not 1; expected a unit vector",
        })
    }
}

impl core::error::Error for NormalError {}

impl<T: Real> Frame<T> {
    /// The frame around a unit vector, without branches. Exact at ±x, ±y and ±z.
    ///
    /// The axes are orthonormal to 4 ulp of 1 when `normal` is a unit vector to 1 ulp; for a
    /// vector of unknown length use [`Frame::new`]. Any input is safe: no panic, and NaN only for
    /// components that are NaN, infinite or beyond the square root of the largest number.
    ///
    /// Source: Duff et al., *Building an Orthonormal Basis, Revisited*, JCGT 6(1), 2017.
    ///
    /// ```
    /// let frame = coslobe::Frame::from_unit([0.0, 0.0, -1.0f32]);
    /// assert_eq!(frame.to_world([0.0, 1.0, 0.0]), [0.0, 0.0, -1.0]);
    /// ```
    #[inline]
    pub fn from_unit(normal: [T; 3]) -> Self {
        let [x, y, z] = normal;
        let sign = T::ONE.copysign(z);
        let a = -T::ONE / (sign + z);
        let b = x * y * a;
        // Zeros are written + 0, so that an axis comes out without negative zeros.
        Frame {
            tangent: [
                T::ONE + sign * x * x * a,
                sign * b + T::ZERO,
                T::ZERO - sign * x,
            ],
            normal,
            bitangent: [T::ZERO - b, T::ZERO - (sign + y * y * a), y],
        }
    }

    /// The frame around any finite vector but zero, scaled to unit length without overflow or
    /// underflow.
    ///
    /// # Errors
    /// If a component is NaN or infinite, or all are zero.
    pub fn new(normal: [T; 3]) -> Result<Self, NormalError> {
        if !normal.iter().all(|c| c.is_finite()) {
            return Err(NormalError::NotFinite);
        }
        let largest = normal
            .iter()
            .fold(T::ZERO, |m, c| if c.abs() > m { c.abs() } else { m });
        if largest == T::ZERO {
            return Err(NormalError::Zero);
        }
        let [x, y, z] = normal.map(|c| c / largest);
        let length = (x * x + y * y + z * z).sqrt();
        Ok(Self::from_unit([x / length, y / length, z / length]))
    }

    /// A local direction (+y along the normal) in world coordinates.
    #[inline]
    pub fn to_world(&self, local: [T; 3]) -> [T; 3] {
        let [x, y, z] = local;
        core::array::from_fn(|i| x * self.tangent[i] + y * self.normal[i] + z * self.bitangent[i])
    }

    /// A world direction in local coordinates: the inverse of [`to_world`](Frame::to_world).
    #[inline]
    pub fn to_local(&self, world: [T; 3]) -> [T; 3] {
        [self.tangent, self.normal, self.bitangent]
            .map(|axis| axis[0] * world[0] + axis[1] * world[1] + axis[2] * world[2])
    }

    /// The axes \[+x, +y = normal, +z\] in world coordinates.
    #[inline]
    pub fn axes(&self) -> [[T; 3]; 3] {
        [self.tangent, self.normal, self.bitangent]
    }
}
