//! Every law and every number type: whoever adds one adds it here, and all that walks these lists
//! has it.

use crate::Number;
pub use crate::visitor::*;
use ::fixed::types::U16F16;
use core::fmt;
use coslobe::integers;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Fast, Lambert, Moments, Precise, SphereShell,
};

/// The exponent of `CosPower` where one is enough: its logarithm is no round number.
pub const EXPONENT: f64 = 7.3;

/// A law by name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Id {
    Disk,
    CircleShell,
    CircleArc,
    Ball,
    SphereShell,
    Lambert,
    /// With this exponent.
    CosPower(f64),
}

impl Id {
    /// The laws without a parameter.
    pub const FIXED: [Id; 6] = [
        Id::Disk,
        Id::CircleShell,
        Id::CircleArc,
        Id::Ball,
        Id::SphereShell,
        Id::Lambert,
    ];

    /// All laws, `CosPower` with [`EXPONENT`].
    pub const ALL: [Id; 7] = [
        Id::Disk,
        Id::CircleShell,
        Id::CircleArc,
        Id::Ball,
        Id::SphereShell,
        Id::Lambert,
        Id::CosPower(EXPONENT),
    ];

    /// Whether samples make θ of two uniforms, each of half the bits.
    pub const fn has_two_uniforms(self) -> bool {
        matches!(self, Id::Disk | Id::Ball | Id::SphereShell)
    }

    /// The law's name, as in the library's documentation and its tables.
    pub const fn name(self) -> &'static str {
        match self {
            Id::Disk => "Disk",
            Id::CircleShell => "CircleShell",
            Id::CircleArc => "CircleArc",
            Id::Ball => "Ball",
            Id::SphereShell => "SphereShell",
            Id::Lambert => "Lambert",
            Id::CosPower(_) => "CosPower",
        }
    }

    /// The law of this name, `CosPower` with [`EXPONENT`].
    pub fn named(name: &str) -> Option<Id> {
        Id::ALL.into_iter().find(|id| id.name() == name)
    }

    /// The law as [`Display`](fmt::Display) writes it.
    pub fn parse(written: &str) -> Option<Id> {
        let power = written
            .strip_prefix("CosPower(")
            .and_then(|k| k.strip_suffix(')'));
        match power {
            Some(k) => k.parse().ok().map(Id::CosPower),
            None => Id::FIXED.into_iter().find(|id| id.name() == written),
        }
    }

    /// Whether it is a law of the plane.
    pub const fn planar(self) -> bool {
        matches!(self, Id::Disk | Id::CircleShell | Id::CircleArc)
    }

    /// k of p ∝ cosᵏθ.
    pub const fn exponent(self) -> f64 {
        match self {
            Id::CircleArc => 0.0,
            Id::CircleShell | Id::Lambert => 1.0,
            Id::Disk | Id::SphereShell => 2.0,
            Id::Ball => 3.0,
            Id::CosPower(k) => k,
        }
    }
}

/// The name, `CosPower` with its exponent.
impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Id::CosPower(k) => write!(f, "CosPower({k})"),
            law => f.pad(law.name()),
        }
    }
}

impl Named for Disk {
    const ID: Id = Id::Disk;
}

impl Named for CircleShell {
    const ID: Id = Id::CircleShell;
}

impl Named for CircleArc {
    const ID: Id = Id::CircleArc;
}

impl Named for Ball {
    const ID: Id = Id::Ball;
}

impl Named for SphereShell {
    const ID: Id = Id::SphereShell;
}

impl Named for Lambert {
    const ID: Id = Id::Lambert;
}

impl<T: Number> Named for CosPower<T> {
    const ID: Id = Id::CosPower(EXPONENT);
}

/// In integers.
impl Named for integers::CosPower {
    const ID: Id = Id::CosPower(EXPONENT);
}

/// Shows one law.
pub fn one_law<T: Number, V: LawVisitor<T>>(id: Id, visitor: &mut V) {
    match id {
        Id::Disk => visitor.planar(id, Disk),
        Id::CircleShell => visitor.planar(id, CircleShell),
        Id::CircleArc => visitor.planar(id, CircleArc),
        Id::Ball => visitor.tangent(id, Ball),
        Id::SphereShell => visitor.tangent(id, SphereShell),
        Id::Lambert => visitor.tangent(id, Lambert),
        Id::CosPower(k) => {
            if let Ok(law) = CosPower::new(T::of(k)) {
                visitor.spatial(id, law);
            }
        }
    }
}

/// Shows the laws without a parameter, then `CosPower` with each of the exponents.
pub fn every_law<T: Number>(visitor: &mut impl LawVisitor<T>, exponents: &[f64]) {
    let powers = exponents.iter().map(|&k| Id::CosPower(k));
    for id in Id::FIXED.into_iter().chain(powers) {
        one_law(id, visitor);
    }
}

/// The moments of one law, or of what `CosPower` does not admit as an exponent `None`.
pub fn moments<T: Number>(id: Id) -> Option<Moments<T>> {
    struct Found<T>(Option<Moments<T>>);
    impl<T: Number> LawVisitor<T> for Found<T> {
        fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
            self.0 = Some(law.moments());
        }
        fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
            self.0 = Some(law.moments());
        }
    }
    let mut found = Found(None);
    one_law(id, &mut found);
    found.0
}

/// Shows every law in integers.
pub fn every_integer_law(visitor: &mut impl IntegerVisitor) {
    visitor.planar(Disk);
    visitor.planar(CircleShell);
    visitor.planar(CircleArc);
    visitor.spatial(Ball);
    visitor.spatial(SphereShell);
    visitor.spatial(Lambert);
    visitor.power(power());
}

/// `CosPower` in integers with the exponent nearest to [`EXPONENT`].
pub fn power() -> integers::CosPower {
    // Rounded by the compiler: firmware in integers has no floats.
    const NEAREST: U16F16 = U16F16::from_bits((EXPONENT * 65536.0 + 0.5) as u32);
    integers::CosPower::new(NEAREST)
}

/// Shows every number type.
pub fn every_number(visitor: &mut impl NumberVisitor) {
    visitor.number::<f32>();
    visitor.number::<f64>();
    visitor.number::<Precise<f32>>();
    visitor.number::<Precise<f64>>();
    visitor.number::<Fast<f32>>();
}
