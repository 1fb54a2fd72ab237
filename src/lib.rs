#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(docsrs, feature(doc_cfg))]
//! TODO

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
pub use number::Real;
pub use point::{Measure, PlanarPoint, Radius, RadiusError, SpatialPoint, Tangent};
pub use rand_core;
pub use tails::Tails;
pub use weight::{balance_heuristic, power_heuristic};
