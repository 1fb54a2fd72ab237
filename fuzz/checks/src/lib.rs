//! What the fuzz targets assert: one module a target, each with `check(data)`.
//!
//! The fuzz targets call them, and `tests/replay.rs`, so that every committed seed is also replayed on stable by
//! `cargo test`.

pub mod cos_power;
pub mod densities;
pub mod fixed;
pub mod frames;
pub mod points;
pub mod quantiles;
pub mod samples;
pub mod scene;
pub mod warps;
pub mod weights;

mod input;
mod measure;
