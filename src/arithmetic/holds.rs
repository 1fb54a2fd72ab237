//! How the numbers of a type enter the arithmetic that its formulas run in.

use super::kernel::Kernel;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

/// A working arithmetic that holds every number of the type `T`.
pub trait Holds<T: Scalar>: Kernel {
    fn from_number(x: T) -> Self;

    /// The same probability: of its tails the nearer one is exact, the other is computed from it
    /// again.
    #[inline(always)]
    fn from_tails(p: Tails<T>) -> Tails<Self> {
        let (p, is_lower) = p.nearer();
        Tails::from_nearer(Self::from_number(p), is_lower == 0)
    }

    /// Both components as they are.
    #[inline(always)]
    fn from_components(at: CosSin<T>) -> CosSin<Self> {
        CosSin {
            cos: Self::from_number(at.cos),
            sin: Self::from_number(at.sin),
        }
    }

    /// The direction that has the smaller component: the larger one is computed from it again,
    /// since its rounding to `T` has moved the direction more.
    #[inline(always)]
    fn from_direction(at: CosSin<T>) -> CosSin<Self> {
        let CosSin { cos, sin } = Self::from_components(at);
        let other = |x: Self, rounded: Self| {
            if rounded.is_nan() {
                rounded
            } else {
                (Self::ONE - x * x).sqrt().copysign(rounded)
            }
        };
        if sin.abs() < cos.abs() {
            CosSin {
                cos: other(sin, cos),
                sin,
            }
        } else {
            CosSin {
                cos,
                sin: other(cos, sin),
            }
        }
    }
}
