//! Accuracy: references, sweeps and the table of allowed errors, shared by the tests and by
//! `examples/accuracy.rs`, which writes the observed table.
#![allow(dead_code, unreachable_pub)] // each user needs a part

pub mod bounds;
pub mod double;
pub mod format;
pub mod inputs;
pub mod inverse;
pub mod measure;
pub mod monotone;
pub mod reference;
pub mod spoiled;
pub mod wide;
