//! One rounding, from double-double to a format with an end to its exponents.

use crate::kernel::double::Double;
use crate::number::f64::power_of_two;

/// A binary format by what rounding to it needs.
pub(super) struct Grid {
    /// Digits of a significand.
    pub(super) digits: i32,
    /// Exponent of the least normal number.
    pub(super) least: i32,
    /// The bits of ∞.
    pub(super) infinity: u64,
}

impl Grid {
    /// Bits of the number nearest to |x|·2ⁿ, ties to even, for a normal, finite x.hi, not 0.
    ///
    /// The trailing word only tells on which side of x.hi the value lies, and of all values there none
    /// that a format has to choose between is nearer than a quarter of x.hi's last place.
    pub(super) fn nearest(&self, x: Double, n: i32) -> u64 {
        let bits = x.hi.abs().to_bits();
        let exponent = (bits >> 52) as i32 - 1023 + n;
        let significand = 4 * ((bits & (u64::MAX >> 12)) | (1 << 52));
        let significand = if x.lo == 0.0 {
            significand
        } else if (x.lo > 0.0) == (x.hi > 0.0) {
            significand + 1
        } else {
            significand - 1
        };
        let below = (self.least - exponent).max(0);
        let shift = 53 - self.digits + 2 + below;
        if shift > 60 {
            return 0; // less than half of the least number
        }
        if exponent > 2000 {
            return self.infinity;
        }
        let (kept, rest) = (significand >> shift, significand & ((1 << shift) - 1));
        let half = 1 << (shift - 1);
        let up = rest > half || (rest == half && kept & 1 == 1);
        // The significand's leading digit counts the exponent up by one, and so does a carry.
        let exponent = (exponent - self.least).max(0) as u64;
        let rounded = (exponent << (self.digits - 1)) + kept + u64::from(up);
        rounded.min(self.infinity)
    }
}

/// Magnitudes from 2⁻⁹⁰⁰ to 2⁹⁰⁰: no trailing word of theirs, nor of what a formula makes of them on the
/// way to such a result, is lost below the subnormals or above the largest number.
#[inline(always)]
pub(super) fn is_moderate(x: f64) -> bool {
    let (low, high) = (power_of_two(-900), power_of_two(900));
    let a = x.abs();
    low <= a && a <= high
}
