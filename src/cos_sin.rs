//! A direction by its cosine and sine.

use crate::scalar::Scalar;

/// A direction by the cosine and sine of its angle θ from the axis.
///
/// Near the axis the sine, near the horizon the cosine holds the digits that an angle beside ±π/2
/// has lost; together they keep full relative accuracy everywhere. Operations that read a
/// direction take it from the smaller of |cos| and |sin| unless they say otherwise. A pair of
/// numbers that is no unit vector to rounding is safe, but no value is promised for it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CosSin<T> {
    /// cos θ.
    pub cos: T,
    /// sin θ; negative for θ < 0, which only planar laws know.
    pub sin: T,
}

impl<T: Scalar> CosSin<T> {
    /// (cos²θ, sin²θ), both from the smaller component: the larger holds fewer digits of θ.
    #[inline(always)]
    pub(crate) fn squares(self) -> Self {
        if self.sin < self.cos {
            let sin = self.sin * self.sin;
            CosSin {
                cos: T::ONE - sin,
                sin,
            }
        } else {
            let cos = self.cos * self.cos;
            CosSin {
                cos,
                sin: T::ONE - cos,
            }
        }
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [T; 2] {
        [self.cos, self.sin]
    }

    #[inline(always)]
    pub(crate) fn from_array([cos, sin]: [T; 2]) -> Self {
        CosSin { cos, sin }
    }

    /// √(x² + y²) without overflow or underflow on the way.
    pub(crate) fn hypot(x: T, y: T) -> T {
        let (x, y) = (x.abs(), y.abs());
        let (large, small) = if x > y { (x, y) } else { (y, x) };
        if large == T::ZERO || !large.is_finite() {
            return large + small;
        }
        let ratio = small / large;
        large * (T::ONE + ratio * ratio).sqrt()
    }
}
