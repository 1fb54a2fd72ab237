//! What tests, fuzzing, studies, firmware and applications share.
//!
//! Without `std`, what firmware computes: samples and evaluations of each law in each number type,
//! as text. Firmware passes its command line to [`answer`] and prints what that writes; the host
//! calls the same function and compares the lines. One that differs names law, type, stream and
//! input.
//!
//! With `std`, what judges results: references, wide arithmetic, measuring and statistics.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
pub mod accuracy;
mod answer;
pub mod batch;
pub mod catalogue;
mod directions;
#[cfg(feature = "peers")]
pub mod formulas;
mod hash;
mod input;
#[cfg(feature = "std")]
pub mod integer;
mod integers;
mod integers16;
mod laws;
mod number;
mod planar;
#[cfg(feature = "planted")]
mod planted;
#[cfg(feature = "std")]
pub mod scratch;
pub mod self_test;
mod spatial;
#[cfg(feature = "std")]
pub mod stats;
mod stream;
#[cfg(feature = "std")]
pub mod study;
mod subject;
mod tiers;
mod visitor;

pub use answer::{Answer, answer};
pub use catalogue::{
    EXPONENT, Id, LawVisitor, Named, NumberVisitor, PlanarLaw, SpatialLaw, TangentLaw,
};
pub use directions::directions;
pub use hash::Hash;
pub use input::mix;
pub use integers::{Integers, integers};
pub use integers16::{Integers16, integers16};
pub use laws::{Laws, Visitor};
pub use number::{Drawn, Format, Number};
pub use planar::planar;
pub use spatial::spatial;
pub use stream::{CHECKPOINTS, Stream};
pub use subject::{Sink, Subject};
pub use tiers::promises_ulps;
