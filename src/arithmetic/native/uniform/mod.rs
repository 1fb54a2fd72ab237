//! Random bits as floats: odd multiples of a power of 2, rounded once.
//!
//! Each is formed in the way that costs least on a kind of processor, always with the same bits.

pub(crate) mod f32;
pub(crate) mod f64;

/// Whether integers become floats in a carrier's last places, not by the processor's conversion.
///
/// On x86-64 a conversion keeps the other lanes of its register and therefore waits for whatever
/// wrote that last: as a rule the sample before, so that samples no longer overlap (some took
/// twice the time). On 32-bit processors a conversion is one instruction or one routine.
const BY_SUMS: bool = cfg!(target_pointer_width = "64");
