//! The laws by name, for what is chosen when the shader runs.

use crate::{Number, Reads, Sampling};
use coslobe::rand_core::Rng;
use coslobe::{Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Lambert, Law, SphereShell};

/// A law, as scene files call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[allow(missing_docs)] // the crate's names
pub enum LawName {
    Lambert,
    SphereShell,
    Ball,
    CosPower,
    CircleArc,
    CircleShell,
    Disk,
}

impl LawName {
    /// The laws of space.
    pub const SPATIAL: [LawName; 4] = [
        LawName::Lambert,
        LawName::SphereShell,
        LawName::Ball,
        LawName::CosPower,
    ];
    /// The laws of flatland.
    pub const PLANAR: [LawName; 3] = [LawName::CircleArc, LawName::CircleShell, LawName::Disk];
}

#[cfg(feature = "serde")]
impl core::str::FromStr for LawName {
    type Err = serde::de::value::Error;
    fn from_str(name: &str) -> Result<Self, Self::Err> {
        serde::Deserialize::deserialize(serde::de::value::StrDeserializer::new(name))
    }
}

impl Reads for Lambert {
    const DIFFUSE: bool = true;
}
impl Reads for SphereShell {
    const SPLITS: bool = true;
}
impl Reads for Ball {
    const SPLITS: bool = true;
}
impl<T: Number> Reads for CosPower<T> {
    const SINE: bool = true;
}
impl Reads for CircleShell {
    const DIFFUSE: bool = true;
}
impl Reads for Disk {
    const SPLITS: bool = true;
}
impl Reads for CircleArc {}

/// Any law of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnySpatial<T: Number> {
    /// cos θ.
    Lambert,
    /// cos²θ.
    SphereShell,
    /// cos³θ.
    Ball,
    /// cosᵏθ.
    Power(CosPower<T>),
}

impl<T: Number> AnySpatial<T> {
    /// The law of that name; `None` of flatland's, or of an exponent that `CosPower` does not
    /// admit.
    pub fn named(name: LawName, exponent: T) -> Option<Self> {
        Some(match name {
            LawName::Lambert => Self::Lambert,
            LawName::SphereShell => Self::SphereShell,
            LawName::Ball => Self::Ball,
            LawName::CosPower => Self::Power(CosPower::new(exponent).ok()?),
            _ => return None,
        })
    }
}

/// Any law of flatland.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyPlanar {
    /// 1.
    CircleArc,
    /// cos θ.
    CircleShell,
    /// cos²θ.
    Disk,
}

impl AnyPlanar {
    /// The law of that name; `None` of those of space.
    pub fn named(name: LawName) -> Option<Self> {
        Some(match name {
            LawName::CircleArc => Self::CircleArc,
            LawName::CircleShell => Self::CircleShell,
            LawName::Disk => Self::Disk,
            _ => return None,
        })
    }
}

/// Each call is passed on to the law.
impl<T: Number> Sampling<[T; 3]> for AnySpatial<T> {
    #[inline(always)]
    fn draw<R: Rng>(&self, axis: [T; 3], rng: &mut R) -> ([T; 3], CosSin<T>, T) {
        match self {
            Self::Lambert => Lambert.draw(axis, rng),
            Self::SphereShell => SphereShell.draw(axis, rng),
            Self::Ball => Ball.draw(axis, rng),
            Self::Power(law) => law.draw(axis, rng),
        }
    }
    #[inline(always)]
    fn density_of(&self, axis: [T; 3], d: [T; 3]) -> T {
        match self {
            Self::Lambert => Lambert.density_of(axis, d),
            Self::SphereShell => SphereShell.density_of(axis, d),
            Self::Ball => Ball.density_of(axis, d),
            Self::Power(law) => law.density_of(axis, d),
        }
    }
    #[inline(always)]
    fn diffuse_weight(&self, at: CosSin<T>) -> T {
        match self {
            Self::Lambert => Lambert.lambert_weight(at),
            Self::SphereShell => SphereShell.lambert_weight(at),
            Self::Ball => Ball.lambert_weight(at),
            Self::Power(law) => law.lambert_weight(at),
        }
    }
    fn mean_cos(&self) -> T {
        match self {
            Self::Lambert => Lambert.mean_cos(),
            Self::SphereShell => SphereShell.mean_cos(),
            Self::Ball => Ball.mean_cos(),
            Self::Power(law) => law.mean_cos(),
        }
    }
}

impl<T: Number> Sampling<[T; 2]> for AnyPlanar {
    #[inline(always)]
    fn draw<R: Rng>(&self, axis: [T; 2], rng: &mut R) -> ([T; 2], CosSin<T>, T) {
        match self {
            Self::CircleArc => CircleArc.draw(axis, rng),
            Self::CircleShell => CircleShell.draw(axis, rng),
            Self::Disk => Disk.draw(axis, rng),
        }
    }
    #[inline(always)]
    fn density_of(&self, axis: [T; 2], d: [T; 2]) -> T {
        match self {
            Self::CircleArc => CircleArc.density_of(axis, d),
            Self::CircleShell => CircleShell.density_of(axis, d),
            Self::Disk => Disk.density_of(axis, d),
        }
    }
    #[inline(always)]
    fn diffuse_weight(&self, at: CosSin<T>) -> T {
        match self {
            Self::CircleArc => CircleArc.lambert_weight(at),
            Self::CircleShell => CircleShell.lambert_weight(at),
            Self::Disk => Disk.lambert_weight(at),
        }
    }
    fn mean_cos(&self) -> T {
        match self {
            Self::CircleArc => Sampling::<[T; 2]>::mean_cos(&CircleArc),
            Self::CircleShell => Sampling::<[T; 2]>::mean_cos(&CircleShell),
            Self::Disk => Sampling::<[T; 2]>::mean_cos(&Disk),
        }
    }
}
