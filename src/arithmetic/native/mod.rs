//! The kernels of `f32` and `f64`, in the format's own operations alone.

pub(crate) mod atan;
pub(crate) mod cbrt;
pub(crate) mod coefficients_f32;
pub(crate) mod coefficients_f64;
pub(crate) mod exp2;
pub(crate) mod f32;
pub(crate) mod f64;
pub(crate) mod float;
pub(crate) mod format;
pub(crate) mod kepler;
mod kernel;
pub(crate) mod log2;
pub(crate) mod moment;
pub(crate) mod pair;
pub(crate) mod poly;
pub(crate) mod power;
pub(crate) mod probability;
pub(crate) mod root;
pub(crate) mod sqrt;
pub(crate) mod table;
pub(crate) mod tail_root;
pub(crate) mod trig;
pub(crate) mod turn;
pub(crate) mod uniform;
