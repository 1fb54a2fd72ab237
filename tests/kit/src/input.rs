//! The inputs of evaluations: a pure function of their index, so that any one can be tried alone.

use crate::Number;
use core::f64::consts::FRAC_PI_2;

/// The numbers that evaluation number `index` starts from.
#[derive(Clone, Copy)]
pub(crate) struct Input<T> {
    /// A probability, an angle, or whatever the bits say.
    pub(crate) x: T,
    /// A second coordinate.
    pub(crate) y: T,
    /// `x` and `y` are any bit patterns, and stand for a direction too.
    pub(crate) hostile: bool,
}

/// In turn: any bit patterns; a probability; an angle a little beyond the support; a number within
/// 2¹⁶ ulp of where a domain ends or a formula changes.
#[inline]
pub(crate) fn input<T: Number>(index: u32) -> Input<T> {
    let (a, b) = (mix(index, 0), mix(index, 1));
    let y = T::of(share(b));
    let kind = index % 4;
    let x = match kind {
        0 => T::of_bits(a),
        1 => T::of(share(a)),
        2 => T::of(3.4 * share(a) - 1.7),
        _ => beside(a),
    };
    let hostile = kind == 0;
    Input {
        x,
        y: if hostile { T::of_bits(b) } else { y },
        hostile,
    }
}

fn beside<T: Number>(word: u64) -> T {
    let ends = [0.0, 1.0, 0.5, 0.25, FRAC_PI_2, -FRAC_PI_2, 1e-30, -0.0];
    let end = T::of(ends[(word & 7) as usize]);
    // As often within 2 ulp as within 2¹⁶.
    let step = (word >> 32 & 0xFFFF) >> (word >> 8 & 15);
    T::of_bits(if word >> 3 & 1 == 0 {
        end.bits().wrapping_add(step)
    } else {
        end.bits().wrapping_sub(step)
    })
}

/// 53 bits as a number in [0, 1), exactly.
fn share(word: u64) -> f64 {
    (word >> 11) as f64 / (1u64 << 53) as f64
}

/// SplitMix64 at a counter.
pub fn mix(index: u32, stream: u32) -> u64 {
    let mut z = (u64::from(index) << 1 | u64::from(stream))
        .wrapping_add(1)
        .wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ z >> 31
}
