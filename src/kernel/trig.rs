//! (cos θ, sin θ) of an angle within the support, and the angle of a pair.

use super::atan::acute;
use super::pair::Pair;
use super::poly::{horner, horner_pair};
use crate::CosSin;
use crate::number::Real;

/// (cos θ, |sin θ|) with what rounding took from each.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairCosSin<T> {
    pub(crate) cos: Pair<T>,
    pub(crate) sin: Pair<T>,
}

impl<T> PairCosSin<T> {
    fn swap_if(self, swap: bool) -> Self {
        if swap {
            PairCosSin {
                cos: self.sin,
                sin: self.cos,
            }
        } else {
            self
        }
    }
}

impl<T: Real> PairCosSin<T> {
    /// ln cos θ. Near the axis it is read from the sine: ln of a cosine near 1 has few digits.
    #[inline]
    pub(crate) fn ln_cos(self) -> T {
        if self.cos.hi < self.sin.hi {
            self.cos.value().ln()
        } else {
            (-self.sin.times(self.sin).value()).ln_1p() * T::HALF
        }
    }
}

/// π/2 − a for 0 ≤ a ≤ π/2, with π/2 to twice the format's digits: cos θ must not
/// lose its own digits where θ runs into ±π/2.
#[inline(always)]
pub(crate) fn from_end<T: Real>(a: T) -> Pair<T> {
    let d = Pair::fast_sum(T::TABLE.half_pi.hi, -a);
    Pair::fast_sum(d.hi, d.lo + T::TABLE.half_pi.lo)
}

/// The angle folded to [0, π/4], and whether cosine and sine change places for it.
#[inline(always)]
fn fold<T: Real>(theta: T) -> (Pair<T>, bool) {
    let a = theta.abs();
    let far = a > T::TABLE.half_pi.hi * T::HALF;
    (if far { from_end(a) } else { Pair::exact(a) }, far)
}

/// (cos x, sin x) for 0 ≤ x ≤ 0.9, hi + lo a fraction of an ulp off: half of this cosine is the pdf of
/// `CircleShell`, whose row in the accuracy table is its error and one rounding.
#[inline]
pub(crate) fn small<T: Real>(x: Pair<T>) -> PairCosSin<T> {
    let v = x.hi * x.hi;
    let half_v = v * T::HALF;
    let w = T::ONE - half_v;
    let rest = x.lo * w + x.hi * v * horner(v, T::TABLE.sin);
    let cos_rest = ((T::ONE - w) - half_v) + (v * v * horner(v, T::TABLE.cos) - x.hi * x.lo);
    PairCosSin {
        cos: Pair::fast_sum(w, cos_rest),
        sin: Pair::fast_sum(x.hi, rest),
    }
}

/// (cos θ, |sin θ|) for |θ| ≤ π/2.
#[inline]
pub(crate) fn at_angle<T: Real>(theta: T) -> PairCosSin<T> {
    let (x, far) = fold(theta);
    small(x).swap_if(far)
}

/// As [`at_angle`], to about 2⁻⁶⁴ (f64) or 2⁻³³ (f32) relative.
#[inline]
pub(crate) fn at_angle_fine<T: Real>(theta: T) -> PairCosSin<T> {
    let (x, far) = fold(theta);
    let v = x.mul(x);
    let sin = x.mul(v).mul(horner_pair(v, &T::TABLE.sin_series)).add(x);
    let cos = v
        .mul(horner_pair(v, &T::TABLE.cos_series))
        .add(Pair::exact(T::ONE));
    PairCosSin { cos, sin }.swap_if(far)
}

/// θ of a unit vector with cos θ ≥ 0, kept within the support: the float nearest π/2 may lie beyond π/2.
#[inline]
pub(crate) fn angle<T: Real>(at: CosSin<T>) -> T {
    into_support(acute(at.sin.abs(), at.cos).copysign(at.sin))
}

/// Moves an angle that rounding put beyond ±π/2 back to the last float inside.
#[inline(always)]
pub(crate) fn into_support<T: Real>(theta: T) -> T {
    if theta > T::HALF_PI_DOWN {
        T::HALF_PI_DOWN
    } else if theta < -T::HALF_PI_DOWN {
        -T::HALF_PI_DOWN
    } else {
        theta
    }
}
