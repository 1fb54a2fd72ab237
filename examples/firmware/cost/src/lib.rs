//! Instructions and stack of every operation, as the board counts them.
//!
//! A binary of `src/bin/` for each number type and each peer prints a line an operation:
//!
//! ```text
//! count TICK_INSTRUCTIONS_IN_TWO REPEATS
//! LAW OPERATION ADDRESS WORDS STACK,BASE_STACK BASE_TICKS TICKS,TICKS,...
//! ```
//!
//! Ticks are of `REPEATS` calls of one input: so many that a call's instructions are the rounded
//! quotient. The host takes off those of a call of a function that only returns
//! (`tools/on_target/src/cost`).
#![no_std]

mod directions;
mod fixed;
mod fixed16;
mod generator;
mod inputs;
mod laws;
mod meter;
pub mod peers;

pub use directions::every_direction;
pub use fixed::every_fixed_law;
pub use fixed16::every_fixed16_law;
pub use laws::every_law;
pub use meter::{Meter, run};
