//! The two formats under test, and errors in units of their last place.

use super::double::Double;
use super::reference::Id;
use super::wide::Wide;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Lambert, Law, Real, Spatial, SphereShell,
};

pub trait Format: Real {
    type Wide: Wide;
    const NAME: &'static str;
    /// Significand bits, and the exponent of the least normal number.
    const DIGITS: i32;
    const LEAST: i32;
    const MAX_VALUE: f64;
    /// Bits of the largest angle within the support, and of ½.
    const TOP_ANGLE: u64;
    const HALF_BITS: u64;
    fn of_bits(bits: u64) -> Self;
    fn bits(self) -> u64;
    fn wide(self) -> f64;
    fn round(x: f64) -> Self;
}

impl Format for f32 {
    type Wide = f64;
    const NAME: &'static str = "f32";
    const DIGITS: i32 = 24;
    const LEAST: i32 = -126;
    const MAX_VALUE: f64 = f32::MAX as f64;
    const TOP_ANGLE: u64 = 0x3FC9_0FDA;
    const HALF_BITS: u64 = 0x3F00_0000;
    fn of_bits(bits: u64) -> f32 {
        f32::from_bits(bits as u32)
    }
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
    fn wide(self) -> f64 {
        f64::from(self)
    }
    fn round(x: f64) -> f32 {
        x as f32
    }
}

impl Format for f64 {
    type Wide = Double;
    const NAME: &'static str = "f64";
    const DIGITS: i32 = 53;
    const LEAST: i32 = -1022;
    const MAX_VALUE: f64 = f64::MAX;
    const TOP_ANGLE: u64 = 0x3FF9_21FB_5444_2D18;
    const HALF_BITS: u64 = 0x3FE0_0000_0000_0000;
    fn of_bits(bits: u64) -> f64 {
        f64::from_bits(bits)
    }
    fn bits(self) -> u64 {
        self.to_bits()
    }
    fn wide(self) -> f64 {
        self
    }
    fn round(x: f64) -> f64 {
        x
    }
}

/// Distance of neighbours of the format at |x|.
pub fn ulp<T: Format>(x: f64) -> f64 {
    let exponent = if x.abs() < f64::MIN_POSITIVE {
        -1022
    } else {
        ((x.to_bits() >> 52) & 0x7FF) as i32 - 1023
    };
    let n = exponent.max(T::LEAST) - T::DIGITS + 1;
    if n >= -1022 {
        f64::from_bits(((n + 1023) as u64) << 52)
    } else {
        f64::from_bits(1 << (n + 1074))
    }
}

/// |got − want| in ulps of `want`; infinite if one is NaN or only one is infinite.
pub fn error_in_ulps<T: Format>(got: T, want: T::Wide) -> f64 {
    let (got, near) = (got.wide(), want.near());
    // A value beyond the format is infinity to it.
    let beyond = near >= T::MAX_VALUE + ulp::<T>(T::MAX_VALUE) / 2.0;
    if got.is_infinite() && (got == near || (got > 0.0 && beyond)) {
        return 0.0;
    }
    let error = want.minus(got).abs() / ulp::<T>(near);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// A law with its name.
pub struct Subject<T> {
    pub id: Id,
    pub law: Box<dyn Law<T> + Send + Sync>,
    pub solid: Option<Box<dyn Fn(T) -> T + Send + Sync>>,
}

impl<T: Format> Subject<T> {
    fn planar(id: Id, law: impl Law<T> + Send + Sync + 'static) -> Self {
        Subject {
            id,
            law: Box::new(law),
            solid: None,
        }
    }

    fn spatial(id: Id, law: impl Spatial<T> + Copy + Send + Sync + 'static) -> Self {
        Subject {
            id,
            law: Box::new(law),
            solid: Some(Box::new(move |theta| law.pdf_solid_angle(theta))),
        }
    }

    pub fn new(id: Id) -> Self {
        match id {
            Id::Disk => Self::planar(id, Disk),
            Id::CircleShell => Self::planar(id, CircleShell),
            Id::CircleArc => Self::planar(id, CircleArc),
            Id::Ball => Self::spatial(id, Ball),
            Id::SphereShell => Self::spatial(id, SphereShell),
            Id::Lambert => Self::spatial(id, Lambert),
            Id::CosPower(k) => {
                let law = CosPower::new(T::round(k)).expect("a valid exponent");
                // The exponent that the format holds is the one to judge by.
                Self::spatial(Id::CosPower(law.exponent().wide()), law)
            }
        }
    }

    pub fn all(ids: &[Id]) -> Vec<Self> {
        ids.iter().map(|&id| Self::new(id)).collect()
    }
}
