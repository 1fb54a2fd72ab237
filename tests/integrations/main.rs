//! The optional features: what each adds, and that none changes a value.

#![cfg(any(
    feature = "defmt",
    feature = "heapless",
    feature = "mint",
    feature = "rand",
    feature = "serde"
))]

#[cfg(any(feature = "heapless", feature = "rand"))]
fn generator() -> rand_pcg::Pcg32 {
    rand_pcg::Pcg32::new(0x0C05_10BE, 7)
}

#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "fixed")]
mod fixed;
#[cfg(feature = "heapless")]
mod heapless;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "rand")]
mod rand;
#[cfg(feature = "serde")]
mod serde;
