//! The sets of effects that are compiled apart: those of the shipped scenes. Any other scene is
//! rendered by the program that asks.

use shade_core::Effect::{
    Absorption, Bounces, Diffuse, Emission, Filter, Gloss, Lamp, Lens, Scattering, Sky, Sun,
};
use shade_core::{Asked, Effects, Number, Only, Set, Vector};

const EMITTER: u32 = Set::of(&[Emission]);
const FURNACE: u32 = Set::of(&[Sky, Diffuse]);
const GRADIENT: u32 = Set::of(&[Filter, Sky, Diffuse]);
const HARD_SHADOW: u32 = Set::of(&[Filter, Sun, Diffuse]);
const LAMP: u32 = Set::of(&[Filter, Lamp, Diffuse]);
const BOX: u32 = Set::of(&[Filter, Lamp, Diffuse, Bounces]);
const GLOSS: u32 = Set::of(&[Filter, Sky, Lamp, Diffuse, Gloss, Bounces]);
const DEPTH_OF_FIELD: u32 = Set::of(&[Filter, Lens, Sky, Emission, Diffuse]);
const FOG: u32 = Set::of(&[Filter, Sun, Diffuse, Bounces, Absorption, Scattering]);
const FLAT_BOUNCES: u32 = Set::of(&[Filter, Sky, Sun, Diffuse, Gloss, Bounces]);
const ALL: u32 = Set::ALL.0;

/// Something that is done with a set of effects.
pub trait Job {
    type Out;
    fn run<E: Effects>(self, e: E) -> Self::Out;
}

/// A world whose scenes' sets are compiled apart.
pub trait Compiled: Vector {
    /// Does the job with exactly `set`.
    fn exactly<J: Job>(set: Set, job: J) -> J::Out;
    /// Whether that is compiled apart.
    fn is_apart(set: Set) -> bool;
}

impl<T: Number> Compiled for [T; 3] {
    fn exactly<J: Job>(set: Set, job: J) -> J::Out {
        match set.0 {
            EMITTER => job.run(Only::<EMITTER>),
            FURNACE => job.run(Only::<FURNACE>),
            GRADIENT => job.run(Only::<GRADIENT>),
            HARD_SHADOW => job.run(Only::<HARD_SHADOW>),
            LAMP => job.run(Only::<LAMP>),
            BOX => job.run(Only::<BOX>),
            GLOSS => job.run(Only::<GLOSS>),
            DEPTH_OF_FIELD => job.run(Only::<DEPTH_OF_FIELD>),
            FOG => job.run(Only::<FOG>),
            ALL => job.run(Only::<ALL>),
            _ => job.run(Asked(set)),
        }
    }
    fn is_apart(set: Set) -> bool {
        let sets = [
            EMITTER,
            FURNACE,
            GRADIENT,
            HARD_SHADOW,
            LAMP,
            BOX,
            GLOSS,
            DEPTH_OF_FIELD,
            FOG,
            ALL,
        ];
        sets.contains(&set.0)
    }
}

impl<T: Number> Compiled for [T; 2] {
    fn exactly<J: Job>(set: Set, job: J) -> J::Out {
        match set.0 {
            LAMP => job.run(Only::<LAMP>),
            FLAT_BOUNCES => job.run(Only::<FLAT_BOUNCES>),
            ALL => job.run(Only::<ALL>),
            _ => job.run(Asked(set)),
        }
    }
    fn is_apart(set: Set) -> bool {
        [LAMP, FLAT_BOUNCES, ALL].contains(&set.0)
    }
}
