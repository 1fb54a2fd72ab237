//! `f64`.

use super::{Code, WORDS_OF_64};
use crate::arithmetic::native::f64::power_of_two;

/// The bits of a float whose last place counts 2ⁿ, n = `ulp`: with an integer below 2⁵² in its last
/// places it is more by that many times 2ⁿ.
const fn carrier(ulp: i32) -> u64 {
    ((1023 + 52 + ulp) as u64) << 52
}

/// (2n + 1)·2⁻¹²⁹ for n < 2¹²⁷, rounded to nearest: never zero; ½ is reached and not passed.
#[inline(always)]
pub(crate) fn tail(n: u128, code: Code) -> f64 {
    match code {
        _ if !WORDS_OF_64 => down::<128>(half_more(n)),
        Code::Scalar => branched(n),
        Code::Vector => selected((n >> 64) as u64, n as u64),
    }
}

/// [`tail`] of the upper half: where that has so many digits, the odd number below it stands for
/// all that follow.
#[inline(always)]
fn branched(n: u128) -> f64 {
    let upper = (n >> 64) as u64;
    if upper >> 54 == 0 {
        return deep(n);
    }
    summed(upper)[0]
}

/// Once in 512 draws.
#[cold]
fn deep(n: u128) -> f64 {
    selected((n >> 64) as u64, n as u64)
}

/// [`tail`] by one sum of floats, which rounds: as in `f32`, of n's halves and of all 78 bits of
/// 2n + 1, or of the leading 104 of n.
#[inline(always)]
fn selected(upper: u64, lower: u64) -> f64 {
    const HIGH: u64 = carrier(52);
    const LOW: u64 = carrier(0);
    const PART: u64 = (1 << 52) - 1;
    // Both at once: the only sum that rounds is the last.
    const CARRIERS: f64 = f64::from_bits(HIGH) + f64::from_bits(LOW);
    let deep = upper >> 13 == 0;
    let high = if deep {
        upper << 13 | lower >> 51
    } else {
        upper >> 11
    };
    let low = if deep {
        lower << 1
    } else {
        upper << 41 | lower >> 23
    };
    let unit = if deep {
        power_of_two(-129)
    } else {
        power_of_two(-105)
    };
    let high = f64::from_bits(HIGH | high) - CARRIERS;
    (high + f64::from_bits(LOW | low & PART | 1)) * unit
}

/// The lower tail (2n + 1)·2⁻⁶⁵ and the upper one, each rounded once: never zero, and 1 is not
/// passed.
#[inline(always)]
pub(crate) fn tails_of_half(n: u64) -> [f64; 2] {
    if WORDS_OF_64 { summed(n) } else { apart(n) }
}

/// The farther tail's last bit, below the digits kept, stands for the half that the nearer one has.
#[inline(always)]
fn apart(n: u64) -> [f64; 2] {
    let is_upper = n >> 63 != 0;
    let n = if is_upper { !n } else { n };
    let p = down::<65>((n << 1 | 1) as f64);
    let q = down::<64>((!n | 1) as f64);
    if is_upper { [q, p] } else { [p, q] }
}

#[inline(always)]
fn summed(n: u64) -> [f64; 2] {
    const HIGH: u64 = carrier(33 - 65);
    const LOW: u64 = carrier(-65);
    const CARRIERS: f64 = f64::from_bits(HIGH) + f64::from_bits(LOW);
    let high = f64::from_bits(HIGH | n >> 32);
    let low = f64::from_bits(LOW | (n << 1 | 1) & 0x1_FFFF_FFFF);
    [(high - CARRIERS) + low, (CARRIERS + 1.0 - high) - low]
}

/// x·2⁻ᴺ for |x| ≥ ½: in the exponent where a product may be a routine.
#[inline(always)]
fn down<const N: i32>(x: f64) -> f64 {
    if WORDS_OF_64 {
        x * power_of_two(-N)
    } else {
        f64::from_bits(x.to_bits().wrapping_sub((N as u64) << 52))
    }
}

/// n + ½ for n < 2¹²⁷, rounded once, for 32-bit processors.
///
/// The general conversion is a library call; one of 64 bits is not. All that lies below those is
/// never zero, and their last bit, itself below the digits kept, stands for it.
#[inline(always)]
fn half_more(n: u128) -> f64 {
    let leading = (n >> 63) as u64;
    if leading >> 55 != 0 {
        (leading | 1) as f64 * power_of_two(63)
    } else {
        let odd = 2 * n + 1;
        let zeros = odd.leading_zeros();
        let odd = odd << zeros;
        let sticky = u64::from(odd as u64 != 0);
        ((odd >> 64) as u64 | sticky) as f64 * power_of_two(63 - zeros as i32)
    }
}

/// (q, n): a uniform azimuth as q quarters and n·2⁻⁶⁵ turns, |n| < 2⁶², n odd.
#[inline(always)]
pub(crate) fn parts_of_turn(bits: u64) -> (u32, i64) {
    // What is left of the quarters are the lower 62 bits, as a signed number.
    (quadrant(bits), ((bits << 2) as i64 >> 1) | 1)
}

#[inline(always)]
fn quadrant(bits: u64) -> u32 {
    (bits.wrapping_add(1 << 61) >> 62) as u32
}

/// (q, x): the same azimuth as q quarters and x turns, |x| ≤ ⅛, x rounded once.
#[inline(always)]
pub(crate) fn turn(bits: u64, code: Code) -> (u32, f64) {
    let x = if WORDS_OF_64 && code == Code::Vector {
        summed_turn(bits)
    } else {
        converted_turn(bits)
    };
    (quadrant(bits), x)
}

#[inline(always)]
fn converted_turn(bits: u64) -> f64 {
    // Four quarters, and twice the half of a unit that a word stands for.
    down::<66>((bits << 2 | 2) as i64 as f64)
}

#[inline(always)]
fn summed_turn(bits: u64) -> f64 {
    const HIGH: u64 = carrier(-34);
    const LOW: u64 = carrier(-66);
    // Twice n but for its last bit; the upper part with ⅛ added, so that it is no less than 0.
    let twice = bits << 2;
    let high = f64::from_bits(HIGH | (twice ^ 1 << 63) >> 32);
    let low = f64::from_bits(LOW | twice & 0xFFFF_FFFF | 2);
    (high - (f64::from_bits(HIGH) + 0.125 + f64::from_bits(LOW))) + low
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All ways of [`tail`] against the compiler's own conversion: every count of leading
    /// zeros, and patterns of low bits around the tie of each.
    #[test]
    fn tails_are_rounded_once() {
        let mut noise = 0x9E37_79B9_7F4A_7C15u128;
        for length in 0..=127 {
            let lead: u128 = (1 << length) >> 1;
            for shift in 0..=length {
                for pattern in 0..16 {
                    noise = noise.wrapping_mul(0xD134_2543_DE82_EF95).wrapping_add(1);
                    let top = u128::MAX >> 1;
                    for low in [
                        pattern << shift,
                        (1 << shift) - 1,
                        noise >> 1,
                        noise >> 1 << shift,
                    ] {
                        for n in [lead | low, lead | low.wrapping_sub(1), lead ^ low] {
                            let n = n & top & (top >> (127 - length));
                            let expected = (2 * n + 1) as f64 * 0.5;
                            assert_eq!(half_more(n).to_bits(), expected.to_bits(), "{n:#x}");
                            let scaled = expected * power_of_two(-128);
                            for found in [branched(n), deep(n)] {
                                assert_eq!(found.to_bits(), scaled.to_bits(), "{n:#x}");
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn tails_of_halves_are_rounded_once() {
        let mut noise = 0x9E37_79B9_7F4A_7C15u64;
        for i in 0..100_000 {
            noise = noise.wrapping_mul(0xD134_2543_DE82_EF95).wrapping_add(1);
            for n in [noise, noise >> (i & 63), noise | ((1 << (i & 63)) - 1)] {
                for n in [n, !n] {
                    let odd = 2 * u128::from(n) + 1;
                    let expected = [odd, (1 << 65) - odd].map(|n| n as f64 * 0.5f64.powi(65));
                    for found in [apart(n), summed(n)] {
                        assert_eq!(
                            found.map(f64::to_bits),
                            expected.map(f64::to_bits),
                            "{n:#x}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn turns_are_rounded_once() {
        let mut noise = 0x9E37_79B9_7F4A_7C15u64;
        for _ in 0..100_000 {
            noise = noise.wrapping_mul(0xD134_2543_DE82_EF95).wrapping_add(1);
            let near = noise >> (noise & 63);
            for eighth in 0..8u64 {
                for bits in [near, near.wrapping_neg(), near ^ 0xFFFF_FFFF] {
                    let bits = (eighth << 61).wrapping_add(bits);
                    let expected = parts_of_turn(bits).1 as f64 * 0.5f64.powi(65);
                    for found in [summed_turn(bits), converted_turn(bits)] {
                        assert_eq!(found.to_bits(), expected.to_bits(), "{bits:#x}");
                    }
                }
            }
        }
    }
}
