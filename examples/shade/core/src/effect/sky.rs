//! Light of the environment.

use crate::{Number, Rgb, Vector};

/// Radiance in proportion to height: from straight below to straight above. Constant if both are
/// equal.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sky<T> {
    /// Radiance from straight below.
    pub nadir: Rgb<T>,
    /// Radiance from straight above.
    pub zenith: Rgb<T>,
}

impl<T: Number> Sky<T> {
    /// Radiance from the direction `d`.
    #[inline(always)]
    pub fn radiance<V: Vector<T = T>>(&self, d: V) -> Rgb<T> {
        let height = (T::ONE + d.up()) * T::HALF;
        // In this form a constant sky is constant to the bit.
        core::array::from_fn(|c| self.nadir[c] + (self.zenith[c] - self.nadir[c]) * height)
    }
}
