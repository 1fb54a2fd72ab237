//! What a draw gives.

use crate::CosSin;

/// A direction, and (cos θ, sin θ) as it was made of them, in Q31.
pub struct Drawn<D> {
    pub(crate) direction: D,
    pub(crate) at: CosSin<i32>,
}
