//! Integer kernels: u32 words as Q31 or Q32, long products counted since a Cortex-M0 pays sixteen instructions for each.

pub(crate) mod angle;
pub(crate) mod cbrt;
pub(crate) mod kepler;
pub(crate) mod mul;
pub(crate) mod normal;
pub(crate) mod poly;
pub(crate) mod recip;
pub(crate) mod sqrt;
pub(crate) mod table;
pub(crate) mod turn;

#[cfg(test)]
mod tests;
