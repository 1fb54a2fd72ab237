//! The laws in closed `f64` forms that share nothing with the crate.
// Its items are those of one test file.
#![allow(unreachable_pub)]

use coslobe::fixed::FixedLaw;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Lambert, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub const Q31: f64 = 2147483648.0;
pub const Q32: f64 = 4294967296.0;

/// A law of the family cosᵏ and its fixed-point operations on bare words.
#[derive(Clone, Copy)]
pub struct Subject {
    pub name: &'static str,
    pub planar: bool,
    pub k: i32,
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

trait Named: FixedLaw<Density = U0F32> + Default {
    const NAME: &'static str;
    const PLANAR: bool;
    const K: i32;
    fn subject() -> Subject {
        Subject {
            name: Self::NAME,
            planar: Self::PLANAR,
            k: Self::K,
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
    const NAME: &'static str = "Disk";
    const PLANAR: bool = true;
    const K: i32 = 2;
}
impl Named for CircleShell {
    const NAME: &'static str = "CircleShell";
    const PLANAR: bool = true;
    const K: i32 = 1;
}
impl Named for CircleArc {
    const NAME: &'static str = "CircleArc";
    const PLANAR: bool = true;
    const K: i32 = 0;
}
impl Named for Ball {
    const NAME: &'static str = "Ball";
    const PLANAR: bool = false;
    const K: i32 = 3;
}
impl Named for SphereShell {
    const NAME: &'static str = "SphereShell";
    const PLANAR: bool = false;
    const K: i32 = 2;
}
impl Named for Lambert {
    const NAME: &'static str = "Lambert";
    const PLANAR: bool = false;
    const K: i32 = 1;
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

/// y with y − sin y = x, by bisection's sure relative: Newton from the series.
fn kepler(x: f64) -> f64 {
    let s = (6.0 * x).cbrt();
    let mut y = s * (1.0 + s * s / 60.0 * (1.0 + s * s * 3.0 / 70.0));
    for _ in 0..4 {
        let square = y * y;
        let (value, slope) = if y < 0.5 {
            let tail = 1.0 - square / 42.0 * (1.0 - square / 72.0 * (1.0 - square / 110.0));
            (
                y * square / 6.0 * (1.0 - square / 20.0 * tail),
                2.0 * (y / 2.0).sin().powi(2),
            )
        } else {
            (y - y.sin(), 1.0 - y.cos())
        };
        if slope > 0.0 {
            y -= (value - x) / slope;
        }
    }
    y
}

/// (cos θ, sin θ) of the law ∝ cosᵏ in space at the tails.
pub fn power_pair(k: f64, lower: f64, upper: f64) -> (f64, f64) {
    let n = k + 1.0;
    // sin² = 1 − (1 − u)^(2/n) without a difference.
    let square = -(2.0 / n * (-lower).ln_1p()).exp_m1();
    (upper.powf(1.0 / n), square.sqrt())
}

impl Subject {
    /// (cos θ, sin θ) at the tails.
    pub fn pair(&self, lower: f64, upper: f64) -> (f64, f64) {
        if !self.planar {
            return power_pair(f64::from(self.k), lower, upper);
        }
        let (p, sign) = if lower < upper {
            (lower, -1.0)
        } else {
            (upper, 1.0)
        };
        match self.k {
            0 => ((PI * p).sin(), sign * (PI * p).cos()),
            1 => (2.0 * (p * (1.0 - p)).sqrt(), sign * (1.0 - 2.0 * p)),
            _ => {
                let eta = kepler(TAU * p) / 2.0;
                (eta.sin(), sign * eta.cos())
            }
        }
    }

    /// [cdf, sf] at θ in turns.
    pub fn tails(&self, turn: f64) -> [f64; 2] {
        let (sin, cos) = (turn * TAU).sin_cos();
        if !self.planar {
            let upper = if turn < 0.0 {
                1.0
            } else if turn >= 0.25 {
                0.0
            } else {
                cos.powi(self.k + 1)
            };
            return [1.0 - upper, upper];
        }
        let upper = if turn >= 0.25 {
            0.0
        } else if turn <= -0.25 {
            1.0
        } else {
            match self.k {
                0 => 0.5 - 2.0 * turn,
                1 => (1.0 - sin) / 2.0,
                _ => 0.5 - 2.0 * turn - sin * cos / PI,
            }
        };
        [1.0 - upper, upper]
    }

    /// Density at cos θ > 0.
    pub fn density_at(&self, cos: f64) -> f64 {
        let scale = match (self.planar, self.k) {
            (true, 0) => 1.0 / PI,
            (true, 1) => 0.5,
            (true, _) => 2.0 / PI,
            (false, k) => f64::from(k + 1) / TAU,
        };
        scale * cos.powi(self.k)
    }

    pub fn pdf_at(&self, turn: f64) -> f64 {
        let theta = turn * TAU;
        let inside = turn <= 0.25 && turn >= if self.planar { -0.25 } else { 0.0 };
        let density = self.density_at(theta.cos().max(0.0));
        match (inside, self.planar) {
            (false, _) => 0.0,
            (true, true) => density,
            (true, false) => density * theta.sin(),
        }
    }

    /// θ in turns at the tails.
    pub fn turn(&self, lower: f64, upper: f64) -> f64 {
        let (cos, sin) = self.pair(lower, upper);
        (sin.atan2(cos)).clamp(-FRAC_PI_2, FRAC_PI_2) / TAU
    }
}
