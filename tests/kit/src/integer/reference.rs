//! The operations of the 32-bit type beside what they should be.

pub use super::truth::power_pair;
use super::truth::{BALL, CIRCLE_ARC, CIRCLE_SHELL, DISK, LAMBERT, SPHERE_SHELL, Truth};
use coslobe::fixed::FixedLaw;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Lambert, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32};
use std::ops::Deref;

pub const Q31: f64 = 2147483648.0;
pub const Q32: f64 = 4294967296.0;

/// A law and its fixed-point operations on bare words.
#[derive(Clone, Copy)]
pub struct Subject {
    pub truth: Truth,
    pub warp: fn(u32) -> CosSin<I1F31>,
    pub warp_sf: fn(u32) -> CosSin<I1F31>,
    pub unwarp: fn(CosSin<I1F31>) -> U0F32,
    pub unwarp_sf: fn(CosSin<I1F31>) -> U0F32,
    pub density: fn(CosSin<I1F31>) -> U0F32,
    pub pdf: fn(i32) -> U0F32,
    pub cdf: fn(i32) -> U0F32,
    pub sf: fn(i32) -> U0F32,
    pub quantile: fn(u32) -> I0F32,
    pub isf: fn(u32) -> I0F32,
}

impl Deref for Subject {
    type Target = Truth;
    fn deref(&self) -> &Truth {
        &self.truth
    }
}

trait Named: FixedLaw<Density = U0F32> + Default {
    const TRUTH: Truth;
    fn subject() -> Subject {
        Subject {
            truth: Self::TRUTH,
            warp: |u| Fixed(Self::default()).warp(U0F32::from_bits(u)),
            warp_sf: |u| Fixed(Self::default()).warp_sf(U0F32::from_bits(u)),
            unwarp: |at| Fixed(Self::default()).unwarp(at),
            unwarp_sf: |at| Fixed(Self::default()).unwarp_sf(at),
            density: |at| Fixed(Self::default()).density(at),
            pdf: |t| Fixed(Self::default()).pdf(I0F32::from_bits(t)),
            cdf: |t| Fixed(Self::default()).cdf(I0F32::from_bits(t)),
            sf: |t| Fixed(Self::default()).sf(I0F32::from_bits(t)),
            quantile: |u| Fixed(Self::default()).quantile(U0F32::from_bits(u)),
            isf: |u| Fixed(Self::default()).isf(U0F32::from_bits(u)),
        }
    }
}

impl Named for Disk {
    const TRUTH: Truth = DISK;
}
impl Named for CircleShell {
    const TRUTH: Truth = CIRCLE_SHELL;
}
impl Named for CircleArc {
    const TRUTH: Truth = CIRCLE_ARC;
}
impl Named for Ball {
    const TRUTH: Truth = BALL;
}
impl Named for SphereShell {
    const TRUTH: Truth = SPHERE_SHELL;
}
impl Named for Lambert {
    const TRUTH: Truth = LAMBERT;
}

pub fn subjects() -> [Subject; 6] {
    [
        Disk::subject(),
        CircleShell::subject(),
        CircleArc::subject(),
        Ball::subject(),
        SphereShell::subject(),
        Lambert::subject(),
    ]
}
