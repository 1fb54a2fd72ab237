//! Other crates' interfaces, each behind the feature of that crate's name; none changes a value.

#[cfg(feature = "heapless")]
pub mod heapless;

#[cfg(feature = "mint")]
mod mint;

#[cfg(feature = "rand")]
mod rand;

#[cfg(feature = "serde")]
mod serde;
