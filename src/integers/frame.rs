//! An orthonormal frame around a normal, in integers.

use super::format::{Component, Format};
use crate::NormalError;

/// A right-handed orthonormal frame whose +y axis is a given normal: [`Frame`](crate::Frame) in
/// integers, of the components `I1F31` or `I1F15`.
///
/// Around +y it is the identity. ±1 saturates to one unit less, so that an axis is as good a normal
/// as another.
///
/// Errors by search (2·10⁶ pairs of vectors, those beside planes and axes among them), in units of
/// the component: to the world's axes at most 8.03 (normal 0.000000578, 0.999999949,
/// −0.0003194273) and back 9.48, a unit vector's length 6.68; in `I1F15` 3, 2.92 and 3.2. The tests
/// allow 10, 12 and 9; 3.5, 3.5 and 4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedFrame<C> {
    normal: [C; 3],
    /// 1/(1 + |z|).
    recip: i32,
}

impl<C: Component> FixedFrame<C> {
    /// The frame around a unit vector.
    ///
    /// Its length may be off 1 by 2⁻²⁰ for `I1F31`, by 2⁻¹² (eight units) for `I1F15`: so far a
    /// vector of `f32` or of 16 bits is off when it is converted.
    ///
    /// # Errors
    /// If the length is further from 1 than that.
    ///
    /// ```
    /// use coslobe::{NormalError, integers::FixedFrame};
    /// use fixed::types::I1F31;
    /// let normal = [0.48f32, 0.6, -0.64].map(I1F31::from_num);
    /// let frame = FixedFrame::new(normal)?;
    /// let up = frame.to_world([I1F31::ZERO, I1F31::MAX, I1F31::ZERO]);
    /// assert!((up[2] - normal[2]).to_bits().abs() <= 4);
    /// assert!(FixedFrame::new([I1F31::ZERO; 3]).is_err());
    /// # Ok::<(), NormalError>(())
    /// ```
    #[inline]
    pub fn new(normal: [C; 3]) -> Result<Self, NormalError> {
        let units = normal.map(C::Format::units);
        if C::Format::square_off(units) > C::Format::SLACK {
            return Err(if units == [0; 3] {
                NormalError::Zero
            } else {
                NormalError::NotUnit
            });
        }
        Ok(Self::from_unit(normal))
    }

    /// The same without the check. Any vector is safe, but no value is promised for one that
    /// [`new`](FixedFrame::new) refuses.
    #[inline]
    pub fn from_unit(normal: [C; 3]) -> Self {
        let [_, _, z] = normal;
        FixedFrame {
            normal,
            recip: C::Format::frame_recip(C::Format::units(z)),
        }
    }

    /// A local direction (+y along the normal) in world coordinates.
    #[inline]
    pub fn to_world(&self, local: [C; 3]) -> [C; 3] {
        let [normal, local] = [self.normal, local].map(|v| v.map(C::Format::units));
        C::Format::to_world(normal, self.recip, local).map(C::Format::of_units)
    }

    /// A world direction in local coordinates: the inverse of [`to_world`](FixedFrame::to_world).
    #[inline]
    pub fn to_local(&self, world: [C; 3]) -> [C; 3] {
        let [normal, world] = [self.normal, world].map(|v| v.map(C::Format::units));
        C::Format::to_local(normal, self.recip, world).map(C::Format::of_units)
    }

    /// The normal.
    #[inline]
    pub fn normal(&self) -> [C; 3] {
        self.normal
    }
}
