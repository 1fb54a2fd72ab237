//! What the fuzz targets assert: one module a target, each with `check(data)`.
//!
//! The fuzz crate has these modules as its library; `tests/fuzz_replay.rs` includes the same files,
//! so that every committed seed is also replayed on stable by `cargo test`.

pub mod cos_power;
pub mod densities;
// The replay of the seeds has it only where the crate has.
#[cfg(feature = "fixed")]
pub mod fixed;
pub mod frames;
pub mod points;
pub mod quantiles;
pub mod samples;
pub mod scene;
pub mod warps;
pub mod weights;

mod float;
mod input;
mod measure;
