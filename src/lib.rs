#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]
//! Direct samplers and densities for directions: the laws p ∝ cosᵏθ that normalising a random point
//! of a disk, circle, ball or sphere tangent to the origin gives.
//!
//! | law | the point is uniform by | density | cdf of θ | sampled by (u uniform) |
//! |---|---|---|---|---|
//! | [`Disk`] | area | 2 cos²θ / π rad⁻¹ | ½ + (θ + sin θ cos θ)/π | Kepler's equation, e = 1 |
//! | [`CircleShell`] | radial shell | cos θ / 2 rad⁻¹ | (1 + sin θ)/2 | sin θ = 2u − 1 |
//! | [`CircleArc`] | arc length | 1/π rad⁻¹ | ½ + θ/π | θ = π(u − ½) |
//! | [`Ball`] | volume | 2 cos³θ / π sr⁻¹ | 1 − cos⁴θ | cos θ = u^¼ |
//! | [`SphereShell`] | radial shell | 3 cos²θ / 2π sr⁻¹ | 1 − cos³θ | cos θ = u^⅓ |
//! | [`Lambert`] = [`SphereArea`] | surface area | cos θ / π sr⁻¹ | sin²θ | cos θ = u^½ |
//! | [`CosPower`] | – | (k+1) cosᵏθ / 2π sr⁻¹ | 1 − cosᵏ⁺¹θ | cos θ = u^(1/(k+1)) |
//!
//! θ is the angle from +y: the disk or ball of radius ρ is centred at (0, ρ) or (0, ρ, 0), and a ray
//! at θ leaves it at r = 2ρ cos θ.
//!
//! ```
//! use coslobe::{Lambert, Law, Spatial};
//! let mut rng = rand_pcg::Pcg32::new(1, 1);
//! let d: [f32; 3] = Lambert.sample(&mut rng); // [sin θ cos φ, cos θ, sin θ sin φ]
//! let world = Lambert.sample_around([0.0, 0.0, 1.0f32], &mut rng);
//! assert!(d[1] > 0.0 && world[2] > 0.0);
//! assert_eq!(Lambert.pdf_solid_angle(0.0), std::f32::consts::FRAC_1_PI);
//! ```
//!
//! # Where to enter
//!
//! Every stage is pure; only `sample` and [`uniform`] touch a generator:
//!
//! words → [`Tails`] ([`uniform`]) → [`CosSin`] ([`Law::warp_tails`]) → direction
//! ([`Spatial::warp_direction`]) → [`Frame`] → weight ([`Law::lambert_weight`]) or point
//! ([`Tangent`]).
//!
//! # Promises
//!
//! No allocation, no panic, no static memory, no unsafe code, no loop that a generator could hold up.
//! The errors of every operation are within the table in [`accuracy`], which the tests read.
//! Samples are unit vectors to 2 ulp, inside the open support, with positive finite density. `f32`
//! uses no `f64` arithmetic. No feature changes a value.
//!
//! Source of the laws: V. Chizhov, *Probability density functions of the normalized disk, circle,
//! ball and sphere*; [`SphereShell`] and [`CircleShell`] say where its measure differs from its
//! problem statement.

pub mod accuracy;
mod cos_sin;
mod frame;
pub mod integration;
mod kernel;
mod law;
mod moments;
mod number;
mod point;
mod tails;
pub mod uniform;
mod weight;

pub use cos_sin::CosSin;
pub use frame::{Frame, NormalError};
pub use law::{
    Ball, CircleArc, CircleShell, CosPower, Disk, ExponentError, Lambert, Law, Planar, Spatial,
    SphereArea, SphereShell,
};
pub use moments::Moments;
pub use number::{Fast, Precise, Real};
pub use point::{Measure, PlanarPoint, Radius, RadiusError, SpatialPoint, Tangent};
pub use rand_core;
pub use tails::Tails;
pub use weight::{balance_heuristic, power_heuristic};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
