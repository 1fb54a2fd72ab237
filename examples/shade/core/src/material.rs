//! How a surface reflects and shines.

use crate::scalar::{int, one, zero};
use crate::{Effect, Meter, Number, Place, Rgb, Sampling, Stream, Vector};
use coslobe::rand_core::Rng;

/// How a surface reflects and shines.
#[derive(Clone, Copy, Debug)]
pub struct Material<V: Vector> {
    /// Albedo of the diffuse part, over the probability that it is chosen.
    pub diffuse: Rgb<V::T>,
    /// R/⟨cos⟩ of the glossy part, over the probability that it is chosen.
    pub gloss: Rgb<V::T>,
    /// The lobe of the glossy part.
    pub lobe: V::Law,
    /// The glossy part is chosen for this many of 2³² words.
    pub share: u64,
    /// Whether it has a diffuse part.
    pub is_diffuse: bool,
    /// Radiance, on both sides.
    pub emission: Rgb<V::T>,
}

impl<V: Vector> Material<V> {
    /// A material; the choice between its parts is in proportion to their largest components.
    pub fn new(
        diffuse: Rgb<V::T>,
        gloss: Rgb<V::T>,
        lobe: V::Law,
        emission: Rgb<V::T>,
    ) -> Material<V> {
        let largest = |c: Rgb<V::T>| c.into_iter().fold(zero(), |a, b| if b > a { b } else { a });
        let (d, g) = (largest(diffuse), largest(gloss));
        // 14 bits are enough of a choice, and exact in every number type.
        let mut share = 0u64;
        let mut rest = if g > zero() { g / (d + g) } else { g };
        for _ in 0..14 {
            rest = rest + rest;
            let bit = rest >= one();
            share = share << 1 | u64::from(bit);
            rest = if bit { rest - one() } else { rest };
        }
        // Both parts have to be met; a material with one part has no choice.
        let share = match (d > zero(), g > zero()) {
            (_, false) => 0,
            (false, true) => 1 << 32,
            (true, true) => share.max(1) << 18,
        };
        let chance = int::<V::T>((share >> 18) as i16) * V::T::from_f32(1.0 / 16384.0);
        let over = |c: Rgb<V::T>, p: V::T| c.map(|x| if x > zero() { x / p } else { x });
        let mean_cos = lobe.mean_cos();
        Material {
            diffuse: over(diffuse, one::<V::T>() - chance),
            gloss: over(gloss, chance * mean_cos),
            lobe,
            share,
            is_diffuse: d > zero(),
            emission,
        }
    }

    /// Whether it has both parts.
    pub fn is_mixed(&self) -> bool {
        self.share != 0 && self.share != 1 << 32
    }

    /// The choice between its parts.
    #[inline(always)]
    pub(crate) fn chooses_gloss<M: Meter>(&self, place: Place, bounce: u32, meter: &mut M) -> bool {
        meter.run(Effect::Mix);
        let word = Stream::new(place, bounce, Effect::Mix, 0, meter).next_u32();
        u64::from(word) < self.share
    }
}
