//! The laws in integers beside closed `f64` forms.

pub mod reference;
pub mod short;
pub mod truth;
