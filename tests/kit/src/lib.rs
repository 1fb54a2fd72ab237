//! The same work on every target: samples and evaluations of each law in each number type, as text.
//!
//! Firmware passes its command line to [`answer`] and prints what that writes; the host calls the same
//! function and compares the lines. One that differs names law, type, stream and input.
#![no_std]
#![forbid(unsafe_code)]

mod answer;
mod directions;
mod hash;
mod input;
mod integers;
mod integers16;
mod laws;
mod number;
mod planar;
#[cfg(feature = "planted")]
mod planted;
mod spatial;
mod stream;
mod subject;

pub use answer::{Answer, answer};
pub use directions::directions;
pub use hash::Hash;
pub use integers::{Integers, integers, power};
pub use integers16::{Integers16, integers16};
pub use laws::{EXPONENT, LAWS, Laws, Named, Visitor};
pub use number::Number;
pub use planar::planar;
pub use spatial::spatial;
pub use stream::{CHECKPOINTS, Stream};
pub use subject::{Sink, Subject};
