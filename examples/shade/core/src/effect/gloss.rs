//! Glossy reflection: a lobe cosᵏα about the mirror direction.

use super::Onward;
use crate::scalar::{infinity, zero};
use crate::vector::dim;
use crate::{Effect, Material, Meter, Place, Rgb, Sampling, Stream, Vector};

/// The modified Phong reflector, which is reciprocal and loses no energy at normal incidence.
///
/// With p the lobe's density (∝ cosᵏα, α from the mirror direction) and ⟨cos⟩ its mean cosine,
/// (k+1)/(k+2):
///
/// > f = R · p(α) / ⟨cos⟩, in space R (k+2)/(2π) cosᵏα
///
/// A sample of the lobe weighs R cos θ / ⟨cos⟩, and nothing below the surface. The albedo is R at
/// normal incidence and less towards grazing, where part of the lobe is below the surface; never
/// more. Source: E. Lafortune and Y. Willems, *Using the modified Phong reflectance model*, 1994.
#[derive(Clone, Copy, Debug)]
pub struct Gloss<'s, V: Vector> {
    /// The unit normal on the side that is seen.
    pub normal: V,
    /// Where a mirror would send the view.
    pub mirror: V,
    /// Whose lobe.
    pub material: &'s Material<V>,
}

impl<V: Vector> Gloss<'_, V> {
    #[inline(always)]
    pub(crate) fn towards(&self, d: V) -> Option<(Rgb<V::T>, V::T)> {
        let cos = self.normal.dot(d);
        let density = self.material.lobe.density_of(self.mirror, d);
        (cos > zero() && density > zero())
            .then(|| (dim(self.material.gloss, cos * density), density))
    }

    /// `None` where the lobe reaches below the surface.
    #[inline(always)]
    pub(crate) fn onward<M: Meter>(
        &self,
        with_density: bool,
        place: Place,
        bounce: u32,
        meter: &mut M,
    ) -> Option<Onward<V>> {
        meter.run(Effect::Gloss);
        meter.ray(Effect::Gloss);
        let lobe = &self.material.lobe;
        let mut words = Stream::new(place, bounce, Effect::Gloss, 0, meter);
        let (direction, _, density) = lobe.draw(self.mirror, &mut words);
        let cos = self.normal.dot(direction);
        (cos > zero()).then(|| Onward {
            direction,
            weight: dim(self.material.gloss, cos),
            density: if with_density { density } else { infinity() },
        })
    }
}
