//! What the laws' formulas run in: the traits, and one folder for each arithmetic with its type,
//! kernels and coefficients. No law and no generator is known here.

pub(crate) mod constants;
pub(crate) mod double;
pub(crate) mod fast;
pub(crate) mod holds;
pub(crate) mod kernel;
pub(crate) mod logarithmic;
pub(crate) mod native;
pub(crate) mod scaled;
