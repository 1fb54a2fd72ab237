//! One rounding, from double-double to a format with an end to its exponents.

use crate::arithmetic::double::Double;
use crate::arithmetic::native::f64::power_of_two;

/// A binary format by what rounding to it needs.
pub(crate) struct Grid {
    /// Digits of a significand.
    pub(crate) digits: i32,
    /// Exponent of the least normal number.
    pub(crate) least: i32,
    /// The bits of ∞.
    pub(crate) infinity: u64,
}

impl Grid {
    pub(crate) const F32: Self = Grid {
        digits: 24,
        least: -126,
        infinity: f32::INFINITY.to_bits() as u64,
    };
    pub(crate) const F64: Self = Grid {
        digits: 53,
        least: -1022,
        infinity: f64::INFINITY.to_bits(),
    };

    /// Bits of the number nearest to |x|·2ⁿ, ties to even, for a normal, finite x.hi, not 0.
    ///
    /// Of x.lo only the sign is read: it tells on which side of x.hi the value lies, and between
    /// the two lies no number of the format and no midpoint of two.
    pub(crate) fn nearest(&self, x: Double, n: i32) -> u64 {
        let bits = x.hi.abs().to_bits();
        let exponent = ((bits >> 52) as i32 - 1023).wrapping_add(n);
        let significand = 4 * ((bits & (u64::MAX >> 12)) | (1 << 52));
        let significand = if x.lo == 0.0 {
            significand
        } else if (x.lo > 0.0) == (x.hi > 0.0) {
            significand + 1
        } else {
            significand - 1
        };
        let below = self.least.wrapping_sub(exponent).max(0);
        let shift = below.wrapping_add(55).wrapping_sub(self.digits);
        if shift > 60 {
            return 0; // less than half of the least number
        }
        if exponent > 2000 {
            return self.infinity;
        }
        let half = 1u64.wrapping_shl(shift.wrapping_sub(1) as u32);
        let kept = significand.wrapping_shr(shift as u32);
        let rest = significand & half.wrapping_shl(1).wrapping_sub(1);
        let up = rest > half || (rest == half && kept & 1 == 1);
        // The significand's leading digit counts the exponent up by one, and so does a carry.
        let exponent = exponent.wrapping_sub(self.least).max(0) as u64;
        let rounded = exponent
            .wrapping_shl(self.digits.wrapping_sub(1) as u32)
            .wrapping_add(kept)
            .wrapping_add(up.into());
        rounded.min(self.infinity)
    }
}

/// Magnitudes from 2⁻⁹⁰⁰ to 2⁹⁰⁰: a formula that goes from such numbers to such a result loses no
/// trailing part of a double-double on the way, neither below the subnormals nor above the largest
/// number.
#[inline(always)]
pub(crate) fn is_moderate(x: f64) -> bool {
    let (low, high) = (power_of_two(-900), power_of_two(900));
    let a = x.abs();
    low <= a && a <= high
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Significands with every kind of end: all zeros, a tie at any place, beside one, mixed.
    fn significands() -> impl Iterator<Item = u64> {
        (0..53).flat_map(|k| {
            let tie = 1u64 << k >> 1;
            [
                tie,
                tie + 1,
                tie.wrapping_sub(1),
                3 * tie,
                0x9E37_79B9_7F4A_7C15 >> k,
            ]
            .map(|s| s & (u64::MAX >> 12))
        })
    }

    /// The hardware rounds once: a product with a power of two, a conversion.
    #[test]
    fn one_word_rounds_as_the_hardware_does() {
        for s in significands() {
            let hi = f64::from_bits(1023 << 52 | s);
            for n in -1022..=1023 {
                let want = (hi * power_of_two(n)).to_bits();
                assert_eq!(
                    Grid::F64.nearest(Double::from_f64(-hi), n),
                    want,
                    "{hi:e} {n}"
                );
                let want = ((hi * power_of_two(n)) as f32).to_bits();
                assert_eq!(
                    Grid::F32.nearest(Double::from_f64(hi), n),
                    u64::from(want),
                    "{hi:e} {n}"
                );
            }
            for below in 1..=70 {
                // Halved exactly, then rounded by the last product.
                let want = (hi * power_of_two(-below) * power_of_two(-1022)).to_bits();
                let n = -1022 - below;
                assert_eq!(
                    Grid::F64.nearest(Double::from_f64(hi), n),
                    want,
                    "{hi:e} {n}"
                );
            }
        }
        assert_eq!(
            Grid::F64.nearest(Double::from_f64(1.0), 1024),
            f64::INFINITY.to_bits()
        );
        assert_eq!(
            Grid::F64.nearest(Double::from_f64(1.0), 1 << 26),
            f64::INFINITY.to_bits()
        );
        assert_eq!(Grid::F64.nearest(Double::from_f64(1.0), -(1 << 26)), 0);
    }

    /// A trailing part decides a tie and nothing else.
    #[test]
    fn the_trailing_word_decides_ties() {
        let lo = power_of_two(-80);
        for s in significands() {
            let hi = f64::from_bits(1023 << 52 | s);
            let at = |lo, n| Grid::F64.nearest(Double { hi, lo }, n);
            for n in -1080..-1022 {
                let (down, middle, up) = (at(-lo, n), at(0.0, n), at(lo, n));
                let dropped = (-1022 - n) as u32;
                let tie = (s | 1 << 52) << (64 - dropped.min(63)) == 1 << 63;
                assert_eq!(up - down, u64::from(tie), "{hi:e} {n}");
                assert!(middle == up || middle == down);
            }
            assert_eq!(at(lo, 0), hi.to_bits());
            assert_eq!(at(-lo, 0), hi.to_bits());
        }
    }
}
