//! The number types.

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
