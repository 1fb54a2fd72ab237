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
//! θ is the angle from +y: the disk or ball of radius ρ is centred at (0, ρ) or (0, ρ, 0), and a
//! ray at θ leaves it at r = 2ρ cos θ.
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
//! # Number types
//!
//! The number type names the accuracy and the cost; the laws and their names stay the same.
//!
//! | type | promise | computed in |
//! |---|---|---|
//! | [`Precise<f32>`](Precise) | correctly rounded | `f64`, double-double where a rounding is close |
//! | [`Precise<f64>`](Precise) | 1 ulp | double-double |
//! | `f32`, `f64` | 4 ulp | the format itself: `f32` never touches `f64` |
//! | [`Fast<f32>`](Fast) | relative error 2⁻¹² | `f32` and 32-bit integers |
//!
//! ```
//! use coslobe::{Disk, Fast, Law, Precise};
//! let exact = Disk.quantile(Precise(0.1f32)).0; // the f32 nearest to the true angle
//! let plain = Disk.quantile(0.1f32);
//! let fast = Disk.quantile(Fast(0.1f32)).0;
//! assert!((plain - exact).abs() <= 2e-7 && (fast - exact).abs() < 3e-4);
//! ```
//!
//! What each costs is in [`accuracy`], measured beside its errors. Where there is no
//! floating-point unit, `Fixed(Disk)` (feature `fixed`) is the same law in integers alone,
//! `Fixed16(Disk)` in 16 bits. [`self_test`] is a self-test for power-on.
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
//! No allocation, no panic, no static memory, no unsafe code, no loop that a generator could hold
//! up. The errors of every operation are within the table in [`accuracy`], which the tests read.
//! Samples are unit vectors to 2 ulp (of [`Fast`]: to 2⁻¹²), inside the open support, with
//! positive finite density. `f32` and `Fast<f32>` use no `f64` arithmetic. No feature changes a
//! value.
//!
//! Source of the laws: V. Chizhov, *Probability density functions of the normalized disk, circle,
//! ball and sphere*; [`SphereShell`] and [`CircleShell`] say where its measure differs from its
//! problem statement.

#[cfg(feature = "std")]
extern crate std;

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!(
    "coslobe gives the same bits on every target, and x87 registers round to more digits than f32 \
     and f64 have: build with RUSTFLAGS=\"-C target-feature=+sse2\", or for an i686 target"
);

pub mod accuracy;
mod arithmetic;
pub mod batch;
mod cos_sin;
mod frame;
mod generator;
#[cfg(feature = "fixed")]
pub mod integers;
pub mod integration;
mod law;
mod moments;
mod number;
mod point;
mod sample;
mod scalar;
pub mod self_test;
mod tails;
pub mod uniform;
mod weight;

pub use batch::{Batch, LengthError};
pub use cos_sin::CosSin;
pub use frame::{Frame, NormalError};
pub use generator::{FromFn, TryFromFn, from_fn, try_from_fn};
#[cfg(feature = "fixed")]
pub use integers::{Fixed, Fixed16};
pub use law::{
    Ball, CircleArc, CircleShell, CosPower, Disk, ExponentError, Lambert, Law, Measure, Planar,
    Spatial, SphereArea, SphereShell,
};
pub use moments::Moments;
pub use number::{Fast, Precise, Real};
pub use point::{PlanarPoint, Radius, RadiusError, SpatialPoint, Tangent};
pub use rand_core;
pub use sample::Sample;
pub use tails::Tails;
pub use weight::{balance_heuristic, power_heuristic};

#[cfg(all(doctest, feature = "fixed"))]
#[doc = include_str!("../README.md")]
struct Readme;
