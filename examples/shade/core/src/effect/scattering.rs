//! Where fog scatters a ray.

use super::{Fog, Onward};
use crate::scalar::one;
use crate::{Effect, Meter, Number, Place, Stream, Vector};
use coslobe::uniform;

/// The length of fog up to the point where the ray is scattered, if that is less than `length`: the
/// optical depth −ln u is exponential.
#[inline(always)]
pub fn scattered_at<V: Vector, M: Meter>(
    fog: &Fog<V>,
    length: V::T,
    place: Place,
    bounce: u32,
    meter: &mut M,
) -> Option<V::T> {
    meter.run(Effect::Scattering);
    let mut words = Stream::new(place, bounce, Effect::Scattering, 0, meter);
    let depth = -uniform::tails::<V::T, _>(&mut words).lower().ln();
    (depth < fog.scattering * length).then(|| depth / fog.scattering)
}

/// A direction uniform all around: in the fog, and at flatland's probes.
#[inline(always)]
pub(crate) fn isotropic<V: Vector, M: Meter>(
    effect: Effect,
    place: Place,
    bounce: u32,
    meter: &mut M,
) -> Onward<V> {
    if effect == Effect::Scattering {
        meter.ray(effect);
    }
    // Part 1: part 0 has the distance.
    let direction = V::isotropic(&mut Stream::new(place, bounce, effect, 1, meter));
    Onward {
        direction,
        weight: [one(); 3],
        density: V::isotropic_density(),
    }
}
