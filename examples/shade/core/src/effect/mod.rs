//! The effects, one a file: what each computes and which random words are its own.

mod absorption;
mod diffuse;
mod filter;
mod gloss;
pub(crate) mod lamp;
mod lens;
mod scattering;
mod sky;
pub(crate) mod sun;

pub use absorption::Fog;
pub use diffuse::Diffuse;
pub use filter::through_pixel;
pub use gloss::Gloss;
pub use lamp::{Combine, Lamp};
pub use lens::through_lens;
pub(crate) use scattering::isotropic;
pub use scattering::scattered_at;
pub use sky::Sky;
pub use sun::Sun;

use crate::{Rgb, Sampling, Vector};

/// How light is scattered at a point of a path: the part of a material that was chosen, or the fog.
#[derive(Clone, Copy, Debug)]
pub enum Lobe<'s, V: Vector> {
    /// Diffuse reflection.
    Diffuse(Diffuse<V>),
    /// Glossy reflection.
    Gloss(Gloss<'s, V>),
    /// Equally to all sides: the fog, and flatland's probes.
    Isotropic,
}

impl<V: Vector> Lobe<'_, V> {
    /// (f·cos θ, density with which the lobe itself would draw `d`); nothing is scattered there if
    /// `None`.
    #[inline(always)]
    pub(crate) fn towards<L: Sampling<V>>(&self, law: &L, d: V) -> Option<(Rgb<V::T>, V::T)> {
        match self {
            Lobe::Diffuse(lobe) => lobe.towards(law, d),
            Lobe::Gloss(lobe) => lobe.towards(d),
            Lobe::Isotropic => {
                let p = V::isotropic_density();
                Some(([p; 3], p))
            }
        }
    }
}

/// Where a path goes on.
#[derive(Clone, Copy, Debug)]
pub struct Onward<V: Vector> {
    /// The direction.
    pub direction: V,
    /// f·cos θ over the density.
    pub weight: Rgb<V::T>,
    /// Density of the direction; computed where lamps ask for it, else ∞.
    pub density: V::T,
}
