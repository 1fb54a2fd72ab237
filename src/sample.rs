//! A direction with what an integrator needs of it.

use crate::CosSin;

/// A drawn direction with its cosine, sine and density.
///
/// `at` and `density` are those of the angle that was drawn: they come before any rotation, so
/// that cos θ > 0 and 0 < density < ∞ hold whatever the rotation rounds `direction` to. A renderer
/// weighs the sample by them and never has to find cos θ again as a dot product, whose error of a
/// few ulps of 1 may be all of a small cosine, or its sign.
///
/// ```
/// use coslobe::{Lambert, Spatial};
/// let mut rng = rand_pcg::Pcg32::new(1, 1);
/// let normal = [0.48f32, 0.6, 0.64];
/// let s = Lambert.sample_around_with_density(normal, &mut rng);
/// // What a white diffuse surface reflects along the sample: f·cos θ/p = 1.
/// let weight = s.at.cos / core::f32::consts::PI / s.density;
/// assert!((weight - 1.0).abs() < 1e-6);
/// ```
///
/// Source: the `Sample { v, pdf }` of Embree's tutorials.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sample<T, const N: usize, D = T> {
    /// The unit vector: of a law's own axes, or around a normal.
    pub direction: [T; N],
    /// (cos θ, sin θ), θ from the law's axis.
    pub at: CosSin<T>,
    /// The law's density at `at`, to the bit: rad⁻¹ in 2D, sr⁻¹ in 3D.
    pub density: D,
}

impl<T, const N: usize, D> Sample<T, N, D> {
    /// The same sample in another frame: `turn` rotates its direction.
    #[inline(always)]
    pub(crate) fn rotated(self, turn: impl FnOnce([T; N]) -> [T; N]) -> Self {
        Sample {
            direction: turn(self.direction),
            ..self
        }
    }
}
