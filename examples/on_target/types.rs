//! The number types.

use coslobe_common::LAWS;

/// As the firmware's build scripts and the documentation name them.
pub(crate) const TYPES: [&str; 6] = [
    "f32",
    "Fast<f32>",
    "f64",
    "Precise<f32>",
    "Precise<f64>",
    FIXED,
];

/// Fixed point.
pub(crate) const FIXED: &str = "Fixed";

/// The laws in a type.
pub(crate) fn laws(number: &str) -> &'static [&'static str] {
    // A real exponent has no fixed point.
    if number == FIXED { &LAWS[..6] } else { &LAWS }
}

/// How many laws there are in all types together.
pub(crate) fn subjects() -> usize {
    TYPES.iter().map(|number| laws(number).len()).sum()
}
