//! The two formats under test, and errors in units of their last place.

use super::double::Double;
use super::long::Long;
use super::wide::Wide;
use crate::Number;

pub trait Format: Number<Raw = Self> {
    type Wide: Wide;
    /// What decides where `Wide` cannot: its digits are more, or its range is.
    type Fine: Wide;
    /// Significand bits, and the exponent of the least normal number.
    const DIGITS: i32;
    const LEAST: i32;
    const MAX_VALUE: f64;
    /// Results below this are judged by `Fine` alone: `Wide` runs out of exponents there.
    const FLOOR: f64;
    /// Decades of the input that share a bin of the stability picture.
    const BIN: f64;
    /// Bits of the largest angle within the support, and of ½.
    const TOP_ANGLE: u64;
    const HALF_BITS: u64;
    /// The nearest numbers to both ends of want ± margin, for `want` away from the least numbers.
    fn bracket(want: Self::Wide, margin: f64) -> (Self, Self);
    /// `got` as `want` is lifted, see `truth`.
    fn lifted(self, lift: f64) -> f64;
}

impl Format for f32 {
    type Wide = f64;
    type Fine = Double;
    const DIGITS: i32 = 24;
    const LEAST: i32 = -126;
    const MAX_VALUE: f64 = f32::MAX as f64;
    const FLOOR: f64 = 0.0;
    const BIN: f64 = 1.0;
    const TOP_ANGLE: u64 = 0x3FC9_0FDA;
    const HALF_BITS: u64 = 0x3F00_0000;
    fn bracket(want: f64, margin: f64) -> (f32, f32) {
        ((want - margin) as f32, (want + margin) as f32)
    }
    fn lifted(self, _: f64) -> f64 {
        f64::from(self) // nothing of this format is ever lifted
    }
}

impl Format for f64 {
    type Wide = Double;
    type Fine = Long;
    const DIGITS: i32 = 53;
    const LEAST: i32 = -1022;
    const MAX_VALUE: f64 = f64::MAX;
    const FLOOR: f64 = 1e-270;
    const BIN: f64 = 7.0;
    const TOP_ANGLE: u64 = 0x3FF9_21FB_5444_2D18;
    const HALF_BITS: u64 = 0x3FE0_0000_0000_0000;
    fn bracket(want: Double, margin: f64) -> (f64, f64) {
        let end = |m: f64| Double::sum(want.hi, want.lo + m).hi;
        (end(-margin), end(margin))
    }
    fn lifted(self, lift: f64) -> f64 {
        self * lift
    }
}

/// Distance of neighbours of the format at |x|.
pub fn ulp<T: Format>(x: f64) -> f64 {
    let exponent = if x.abs() < f64::MIN_POSITIVE {
        -1022
    } else {
        ((x.to_bits() >> 52) & 0x7FF) as i32 - 1023
    };
    let n = exponent.max(T::LEAST) - T::DIGITS + 1;
    if n >= -1022 {
        f64::from_bits(((n + 1023) as u64) << 52)
    } else {
        f64::from_bits(1 << (n + 1074))
    }
}

/// |got − want| in ulps of `want`; infinite if one is NaN or only one is infinite.
pub fn error_in_ulps<T: Format>(got: T, want: T::Wide) -> f64 {
    let (got, near) = (got.wide(), want.near());
    // A value beyond the format is infinity to it.
    let beyond = near >= T::MAX_VALUE + ulp::<T>(T::MAX_VALUE) / 2.0;
    if got.is_infinite() && (got == near || (got > 0.0 && beyond)) {
        return 0.0;
    }
    let error = want.minus(got).abs() / ulp::<T>(near);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The number of the format nearest to x·2⁻ⁿ, ties to even; 2ⁿ lifts subnormal values off the
/// floor.
pub fn nearest<T: Format>(x: Double, n: i32) -> T {
    let unit = ulp::<T>(x.hi * 2f64.powi(-n)) * 2f64.powi(n);
    let last = x.hi / unit;
    // x.hi has more bits than the format, or is the answer up to a tie that x.lo decides.
    let (below, part) = (last.floor(), last - last.floor());
    let up = if part == 0.5 && x.lo != 0.0 {
        x.lo > 0.0
    } else if part == 0.5 {
        below % 2.0 != 0.0
    } else if part == 0.0 && x.lo.abs() == unit / 2.0 {
        // Half a unit from an integer: up from odd, down from odd.
        let odd = below % 2.0 != 0.0;
        return T::of(place(
            if odd { below + x.lo.signum() } else { below },
            unit,
            n,
        ));
    } else {
        part > 0.5
    };
    T::of(place(below + f64::from(u8::from(up)), unit, n))
}

/// count·unit·2⁻ⁿ, exactly: a number of the format, or beyond its largest.
fn place(count: f64, unit: f64, n: i32) -> f64 {
    count * (unit * 2f64.powi(-n))
}
