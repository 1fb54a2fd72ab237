//! Diffuse reflection: f = albedo/π, in flatland albedo/2.

use super::Onward;
use crate::scalar::{infinity, zero};
use crate::vector::dim;
use crate::{Effect, Meter, Place, Rgb, Sampling, Stream, Vector};

/// A diffuse surface.
#[derive(Clone, Copy, Debug)]
pub struct Diffuse<V: Vector> {
    /// The unit normal on the side that is seen.
    pub normal: V,
    /// The albedo, over the probability that this part was chosen.
    pub albedo: Rgb<V::T>,
}

impl<V: Vector> Diffuse<V> {
    #[inline(always)]
    pub(crate) fn towards<L: Sampling<V>>(&self, law: &L, d: V) -> Option<(Rgb<V::T>, V::T)> {
        let cos = self.normal.dot(d);
        (cos > zero()).then(|| {
            let reflected = dim(self.albedo, V::diffuse_density(cos));
            (reflected, law.density_of(self.normal, d))
        })
    }

    /// A direction by `law`. Under the law of diffuse reflection itself the weight is the albedo,
    /// and under a constant sky there is no variance.
    #[inline(always)]
    pub(crate) fn onward<L: Sampling<V>, M: Meter>(
        &self,
        law: &L,
        with_density: bool,
        place: Place,
        bounce: u32,
        meter: &mut M,
    ) -> Onward<V> {
        meter.run(Effect::Diffuse);
        meter.ray(Effect::Diffuse);
        let mut words = Stream::new(place, bounce, Effect::Diffuse, 0, meter);
        let (direction, at, density) = law.draw(self.normal, &mut words);
        Onward {
            direction,
            weight: dim(self.albedo, law.diffuse_weight(at)),
            density: if with_density { density } else { infinity() },
        }
    }
}
