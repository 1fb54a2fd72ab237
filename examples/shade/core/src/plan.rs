//! Effects, sets of them, and the two ways to say which are on.

use crate::{Number, Vector};
use coslobe::uniform::TurnBits;

/// What can be simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Effect {
    /// The ray through a pixel's centre; in flatland a probe of the light at the pixel. Never
    /// absent.
    Camera,
    /// Antialiasing: rays spread over the pixel.
    Filter,
    /// Depth of field of a thin lens.
    Lens,
    /// Light of the environment.
    Sky,
    /// Surfaces that shine, met by chance.
    Emission,
    /// A light at infinity: hard shadows.
    Sun,
    /// Spherical lights, sampled: soft shadows.
    Lamp,
    /// Diffuse reflection.
    Diffuse,
    /// Glossy reflection.
    Gloss,
    /// The choice between the two on a surface that has both.
    Mix,
    /// More than one scattering.
    Bounces,
    /// Fog that absorbs.
    Absorption,
    /// Fog that scatters.
    Scattering,
}

use Effect::*;

impl Effect {
    /// Number of effects.
    pub const COUNT: usize = 13;
    /// All effects.
    pub const ALL: [Effect; Effect::COUNT] = [
        Camera, Filter, Lens, Sky, Emission, Sun, Lamp, Diffuse, Gloss, Mix, Bounces, Absorption,
        Scattering,
    ];

    /// As the plan prints it.
    pub const fn name(self) -> &'static str {
        match self {
            Camera => "camera",
            Filter => "pixel filter",
            Lens => "depth of field",
            Sky => "environment light",
            Emission => "emitters",
            Sun => "hard shadow (sun)",
            Lamp => "soft shadow (lamps)",
            Diffuse => "diffuse reflection",
            Gloss => "glossy reflection",
            Mix => "diffuse and glossy at once",
            Bounces => "several bounces",
            Absorption => "fog: absorption",
            Scattering => "fog: scattering",
        }
    }

    /// What one entry into the effect costs in the world of `V`. The ray of a reflection is the one
    /// that leaves the surface.
    pub fn cost<V: Vector>(self) -> Cost {
        let tail = V::T::TAIL_WORDS;
        let turn = size_of::<TurnBits<V::T>>() / 4;
        let direction = if V::DIM == 3 { tail + turn } else { tail };
        let (words, rays) = match self {
            Camera => (if V::DIM == 2 { turn } else { 0 }, 1),
            Filter | Mix => (1, 0),
            Lens => (tail + turn, 0),
            Sky | Emission | Bounces | Absorption => (0, 0),
            Sun => (0, 1),
            Lamp | Diffuse | Gloss => (direction, 1),
            // The distance; what scatters there needs a direction, and its ray, as well.
            Scattering => (tail, 0),
        };
        Cost {
            words: words as u32,
            rays,
        }
    }
}

/// 32-bit random words and rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Random words.
    pub words: u32,
    /// Rays.
    pub rays: u32,
}

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Set(pub u32);

impl Set {
    /// The camera alone.
    pub const LEAST: Set = Set(1 << Camera as u32);
    /// Every effect.
    pub const ALL: Set = Set((1 << Effect::COUNT) - 1);

    /// With one more.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Set {
        Set(self.0 | 1 << effect as u32)
    }
    /// With one more, if.
    #[must_use]
    pub const fn with_if(self, effect: Effect, called_for: bool) -> Set {
        if called_for { self.with(effect) } else { self }
    }
    /// Whether it has `effect`.
    #[inline(always)]
    pub const fn has(self, effect: Effect) -> bool {
        self.0 >> effect as u32 & 1 != 0
    }
    /// The least and these: for the parameter of [`Only`].
    pub const fn of(effects: &[Effect]) -> u32 {
        let mut set = Set::LEAST;
        let mut i = 0;
        while i < effects.len() {
            set = set.with(effects[i]);
            i += 1;
        }
        set.0
    }
    /// Its members.
    pub fn iter(self) -> impl Iterator<Item = Effect> {
        Effect::ALL.into_iter().filter(move |&e| self.has(e))
    }
}

/// Tells the integrator which effects are on.
pub trait Effects: Copy + Send + Sync + 'static {
    /// Whether `effect` is on.
    fn on(self, effect: Effect) -> bool;
    /// The whole set.
    fn set(self) -> Set;
}

/// Which effects are on is part of the type: the code of the others is not compiled.
#[derive(Clone, Copy, Debug, Default)]
pub struct Only<const SET: u32>;

impl<const SET: u32> Effects for Only<SET> {
    #[inline(always)]
    fn on(self, effect: Effect) -> bool {
        const { Set(SET) }.has(effect)
    }
    fn set(self) -> Set {
        Set(SET)
    }
}

/// Which effects are on is asked as the render goes: one program for all scenes.
#[derive(Clone, Copy, Debug)]
pub struct Asked(pub Set);

impl Effects for Asked {
    #[inline(always)]
    fn on(self, effect: Effect) -> bool {
        self.0.has(effect)
    }
    fn set(self) -> Set {
        self.0
    }
}
