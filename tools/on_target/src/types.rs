//! The number types.

use kit::Id;

/// As the firmware's build scripts and the documentation name them.
pub(crate) const TYPES: [&str; 7] = [
    "f32",
    "Fast<f32>",
    "f64",
    "Precise<f32>",
    "Precise<f64>",
    FIXED,
    FIXED16,
];

/// Fixed point.
pub(crate) const FIXED: &str = "Fixed";
pub(crate) const FIXED16: &str = "Fixed16";

/// The laws in a type.
pub(crate) fn laws(number: &str) -> Vec<&'static str> {
    // A real exponent needs more than 16 bits.
    let laws: &[Id] = if number == FIXED16 {
        &Id::FIXED
    } else {
        &Id::ALL
    };
    laws.iter().map(|law| law.name()).collect()
}
