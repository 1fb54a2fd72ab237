//! Random bits as floats: odd multiples of a power of 2, rounded once.
//!
//! Each is formed in the way that costs least on a kind of processor, always with the same bits.

pub(crate) mod f32;
pub(crate) mod f64;

/// What random bits are for: one number, or an element of a loop that becomes vectors.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Code {
    /// A rare case is branched to.
    Scalar,
    /// It is selected, with both at hand.
    Vector,
}

/// Whether integers of 64 bits become floats in carriers' last places.
///
/// On x86-64 a conversion keeps the other lanes of its register and therefore waits for whatever
/// wrote that last, which may be the sample before, so that samples no longer overlap; and of 64
/// bits few vectors have one. Integers of 32 bits are converted all the same: that pays in every
/// loop that was measured. On 32-bit processors a conversion is one instruction or one routine.
const WORDS_OF_64: bool = cfg!(target_pointer_width = "64");
