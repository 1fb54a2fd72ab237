//! Promise: total functions. NaN in, NaN out; ±∞, −0 and what lies outside the support have their
//! values.
//!
//! Fuzzing's checks, replayed by `cargo test -p checks`, hold every number type to the same.

mod borders;
mod precise;
