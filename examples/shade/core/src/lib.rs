#![no_std]
#![forbid(unsafe_code)]
#![allow(clippy::neg_cmp_op_on_partial_ord)] // NaN goes the same way as what fails
//! A path tracer that simulates only the effects that its scene calls for.
//!
//! One integrator ([`radiance`]) serves space and flatland and every number type of `coslobe`: both
//! are chosen by the vector type, `[f32; 3]`, `[f64; 2]`, …. What a scene calls for is a [`Set`] of
//! [`Effect`]s. An absent effect draws no random word, traces no ray and runs none of its code:
//! under [`Only`] the set is part of the type and the code is not even compiled; under [`Asked`]
//! one program serves every scene, at the price of a test of a bit where an effect would begin.
//!
//! Every effect has random numbers of its own ([`Stream`]): those at (pixel, sample, bounce,
//! effect) do not depend on which other effects are simulated. So an image rendered with effects
//! forced on that do nothing (fog of density 0, a lens of radius 0, …) is the same to the bit.

pub mod effect;
mod film;
mod geometry;
mod law;
mod laws;
mod material;
mod meter;
mod number;
mod path;
mod plan;
mod scalar;
mod scene;
mod start;
mod stream;
mod vector;

pub use film::{Pixel, pixel};
pub use geometry::{Hit, Plate, Ray, Sphere, Target};
pub use law::{Reads, Sampling};
pub use laws::{AnyPlanar, AnySpatial, LawName};
pub use material::Material;
pub use meter::{Aligned, Counters, Meter};
pub use number::{Number, NumberVisitor, every_number};
pub use path::radiance;
pub use plan::{Asked, Cost, Effect, Effects, Only, Set};
pub use scene::{Camera, Scene};
pub use start::Aim;
pub use stream::{Place, Stream};
pub use vector::Vector;

/// Red, green, blue: radiance, reflectance, transmittance.
pub type Rgb<T> = [T; 3];
