//! What the fuzz targets assert: one module a target, each with `check(data)`.
//!
//! The fuzz targets call them, and `tests/replay.rs`, so that every committed seed is also replayed
//! on stable by `cargo test`.

pub mod floats;
pub mod integers;
#[cfg(feature = "scene")]
pub mod scene;

mod cos_power;
mod densities;
mod frames;
mod input;
mod judged;
mod measure;
mod points;
mod quantiles;
mod samples;
mod warps;
mod weights;
