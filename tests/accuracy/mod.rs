//! Accuracy: references, sweeps and the table of allowed errors, shared by `tests/error_bounds.rs`
//! and by `examples/accuracy.rs`, which writes the observed table.
#![allow(dead_code, unreachable_pub)] // each of the two uses a part

pub mod bounds;
pub mod double;
pub mod format;
pub mod inputs;
pub mod measure;
pub mod monotone;
pub mod reference;
pub mod wide;
