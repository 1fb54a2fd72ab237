//! A light at infinity: hard shadows.

use crate::path::{Path, Vertex};
use crate::scalar::{infinity, one, zero};
use crate::vector::tint;
use crate::{Effect, Effects, Meter, Ray, Rgb, Sampling, Target, Vector};

/// Parallel light.
#[derive(Clone, Copy, Debug)]
pub struct Sun<V: Vector> {
    /// Unit vector to the sun.
    pub towards: V,
    /// Irradiance of a surface that faces it.
    pub irradiance: Rgb<V::T>,
}

impl<V: Vector> Sun<V> {
    /// No light, from above.
    pub fn neutral() -> Self {
        let up = |i| if i == 1 { one() } else { zero() };
        Sun {
            towards: V::from_fn(up),
            irradiance: [zero(); 3],
        }
    }
}

/// The sun's light scattered at the vertex. A surface that looks away from it asks for no ray.
#[inline(always)]
pub(crate) fn scattered<'s, V: Vector, E: Effects, L: Sampling<V>, M: Meter>(
    path: &mut Path<'s, V, E, L, M>,
    (origin, lobe): &Vertex<'s, V>,
) -> Rgb<V::T> {
    path.meter.run(Effect::Sun);
    let (scene, black) = (path.scene, [zero(); 3]);
    let Some((reflected, _)) = lobe.towards(path.law, scene.sun.towards) else {
        return black;
    };
    let ray = Ray {
        origin: *origin,
        direction: scene.sun.towards,
    };
    path.meter.ray(Effect::Sun);
    let far = infinity();
    if !scene.is_clear(path.e, &ray, far, Target::NONE) {
        return black;
    }
    let light = tint(reflected, scene.sun.irradiance);
    scene.fog.veil(path.e, &ray, far, light)
}
