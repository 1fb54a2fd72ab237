//! The same operations in the obvious way: the textbook's formulas in a library's functions.
//!
//! Boards count what they cost, the host measures their errors.

use crate::Id;
use core::f32::consts::{FRAC_1_PI, FRAC_2_PI, PI, TAU};

/// Exponent of the power law.
pub const EXPONENT: f32 = 20.0;

/// The functions of a library.
pub trait Maths: Copy {
    fn sqrt(x: f32) -> f32;
    fn cbrt(x: f32) -> f32;
    fn sin_cos(x: f32) -> (f32, f32);
    fn cos(x: f32) -> f32;
    fn powf(x: f32, y: f32) -> f32;
    fn asin(x: f32) -> f32;
    fn acos(x: f32) -> f32;
}

/// The `libm` crate.
#[derive(Clone, Copy)]
pub struct Libm;

impl Maths for Libm {
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    fn cbrt(x: f32) -> f32 {
        libm::cbrtf(x)
    }
    fn sin_cos(x: f32) -> (f32, f32) {
        libm::sincosf(x)
    }
    fn cos(x: f32) -> f32 {
        libm::cosf(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        libm::powf(x, y)
    }
    fn asin(x: f32) -> f32 {
        libm::asinf(x)
    }
    fn acos(x: f32) -> f32 {
        libm::acosf(x)
    }
}

/// The `micromath` crate: approximations for embedded use.
#[derive(Clone, Copy)]
pub struct Micromath;

impl Maths for Micromath {
    fn sqrt(x: f32) -> f32 {
        micromath::F32Ext::sqrt(x)
    }
    fn cbrt(x: f32) -> f32 {
        micromath::F32Ext::powf(x, 1.0 / 3.0) // it has no cube root
    }
    fn sin_cos(x: f32) -> (f32, f32) {
        micromath::F32Ext::sin_cos(x)
    }
    fn cos(x: f32) -> f32 {
        micromath::F32Ext::cos(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        micromath::F32Ext::powf(x, y)
    }
    fn asin(x: f32) -> f32 {
        micromath::F32Ext::asin(x)
    }
    fn acos(x: f32) -> f32 {
        micromath::F32Ext::acos(x)
    }
}

/// A law of space, k its exponent.
#[derive(Clone, Copy, PartialEq)]
pub enum Space {
    Lambert,
    SphereShell,
    Ball,
    CosPower,
}

impl Space {
    /// The law of this name, if it is one of space.
    pub const fn of(id: Id) -> Option<Space> {
        match id {
            Id::Lambert => Some(Space::Lambert),
            Id::SphereShell => Some(Space::SphereShell),
            Id::Ball => Some(Space::Ball),
            Id::CosPower(_) => Some(Space::CosPower),
            _ => None,
        }
    }

    fn exponent(self) -> f32 {
        match self {
            Space::Lambert => 1.0,
            Space::SphereShell => 2.0,
            Space::Ball => 3.0,
            Space::CosPower => EXPONENT,
        }
    }

    /// cos θ = u^(1/(k+1)), by the root that an author would take.
    #[inline(always)]
    fn cosine<M: Maths>(self, u: f32) -> f32 {
        match self {
            Space::Lambert => M::sqrt(u),
            Space::SphereShell => M::cbrt(u),
            Space::Ball => M::sqrt(M::sqrt(u)),
            Space::CosPower => M::powf(u, 1.0 / (EXPONENT + 1.0)),
        }
    }

    /// cosⁿθ, n = k or k + 1.
    #[inline(always)]
    fn power<M: Maths>(self, cos: f32, n: f32) -> f32 {
        let square = cos * cos;
        match n {
            1.0 => cos,
            2.0 => square,
            3.0 => square * cos,
            4.0 => square * square,
            _ => M::powf(cos, n),
        }
    }

    /// [sin θ cos φ, cos θ, sin θ sin φ] at sf = u and azimuth 2πv: the polar form.
    #[inline(always)]
    pub fn direction<M: Maths>(self, u: f32, v: f32) -> [f32; 3] {
        let cos = self.cosine::<M>(u);
        let sin = match self {
            Space::Lambert => M::sqrt(1.0 - u),
            _ => M::sqrt(1.0 - cos * cos),
        };
        let (s, c) = M::sin_cos(TAU * v);
        [sin * c, cos, sin * s]
    }

    #[inline(always)]
    pub fn pdf<M: Maths>(self, theta: f32) -> f32 {
        let (s, c) = M::sin_cos(theta);
        let k = self.exponent();
        (k + 1.0) / TAU * self.power::<M>(c, k) * s
    }

    #[inline(always)]
    pub fn cdf<M: Maths>(self, theta: f32) -> f32 {
        1.0 - self.power::<M>(M::cos(theta), self.exponent() + 1.0)
    }

    #[inline(always)]
    pub fn quantile<M: Maths>(self, p: f32) -> f32 {
        M::acos(self.cosine::<M>(1.0 - p))
    }
}

/// A law of the plane.
#[derive(Clone, Copy, PartialEq)]
pub enum Plane {
    Disk,
    CircleShell,
    CircleArc,
}

impl Plane {
    /// The law of this name, if it is one of the plane.
    pub const fn of(id: Id) -> Option<Plane> {
        match id {
            Id::Disk => Some(Plane::Disk),
            Id::CircleShell => Some(Plane::CircleShell),
            Id::CircleArc => Some(Plane::CircleArc),
            _ => None,
        }
    }

    /// [sin θ, cos θ]; only the disk's takes a second uniform number.
    #[inline(always)]
    pub fn direction<M: Maths>(self, u: f32, v: impl FnOnce() -> f32) -> [f32; 2] {
        let sin = match self {
            // The x coordinate of a uniform point of the unit disk.
            Plane::Disk => M::sqrt(u) * M::cos(TAU * v()),
            Plane::CircleShell => u + u - 1.0,
            Plane::CircleArc => {
                let (s, c) = M::sin_cos(PI * (u - 0.5));
                return [s, c];
            }
        };
        [sin, M::sqrt(1.0 - sin * sin)]
    }

    #[inline(always)]
    pub fn pdf<M: Maths>(self, theta: f32) -> f32 {
        match self {
            Plane::Disk => {
                let c = M::cos(theta);
                FRAC_2_PI * c * c
            }
            Plane::CircleShell => 0.5 * M::cos(theta),
            Plane::CircleArc => FRAC_1_PI,
        }
    }

    #[inline(always)]
    pub fn cdf<M: Maths>(self, theta: f32) -> f32 {
        match self {
            Plane::Disk => {
                let (s, c) = M::sin_cos(theta);
                0.5 + (theta + s * c) * FRAC_1_PI
            }
            Plane::CircleShell => 0.5 * (1.0 + M::sin_cos(theta).0),
            Plane::CircleArc => 0.5 + theta * FRAC_1_PI,
        }
    }

    /// The disk's has no closed form.
    #[inline(always)]
    pub fn quantile<M: Maths>(self, p: f32) -> Option<f32> {
        match self {
            Plane::Disk => None,
            Plane::CircleShell => Some(M::asin(p + p - 1.0)),
            Plane::CircleArc => Some(PI * (p - 0.5)),
        }
    }
}

/// A Lambert direction in integers, components in Q31: square roots of 16 bits, and `idsp`'s cosine
/// and sine.
#[inline(always)]
pub fn lambert_by_idsp(u: u32, turn: u32) -> [i32; 3] {
    let (cos, sin) = (u.isqrt() as i32, (!u).isqrt() as i32);
    let (c, s) = idsp::cossin(turn as i32);
    [(c >> 16) * sin, cos << 15, (s >> 16) * sin]
}
