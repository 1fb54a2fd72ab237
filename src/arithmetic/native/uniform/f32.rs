//! `f32`.

use super::{Code, WORDS_OF_64};
use crate::arithmetic::native::f32::power_of_two;

const TWO_TO_MINUS_47: f32 = f32::from_bits((127 - 47) << 23);
const TWO_TO_MINUS_65: f32 = f32::from_bits((127 - 65) << 23);

/// The bits of a float whose last place counts 2ⁿ, n = `ulp`: with an integer below 2²³ in its last
/// places it is more by that many times 2ⁿ.
const fn carrier(ulp: i32) -> u32 {
    ((127 + 23 + ulp) as u32) << 23
}

/// (2n + 1)·2⁻⁶⁵ for n < 2⁶³, rounded to nearest: never zero; ½ is reached and not passed.
#[inline(always)]
pub(crate) fn tail(n: u64, code: Code) -> f32 {
    match code {
        _ if !WORDS_OF_64 => assembled(n),
        Code::Scalar => branched(n),
        Code::Vector => selected((n >> 32) as u32, n as u32),
    }
}

/// [`tail`] by a sum of the leading 46 bits. The last of them lies below the digits kept and stands
/// for all that follow.
#[inline(always)]
fn branched(n: u64) -> f32 {
    if n >> 42 == 0 {
        return deep(n);
    }
    let n = n >> 17;
    sum((n >> 23) as u32, n as u32 | 1) * TWO_TO_MINUS_47
}

/// Once in two million draws.
#[cold]
fn deep(n: u64) -> f32 {
    assembled(n)
}

/// [`tail`] by the same sum or, where 2n + 1 has no more than 43 bits, by one of all of them.
///
/// n's halves are given apart: of the whole a compiler would make vectors of half as many elements.
#[inline(always)]
fn selected(upper: u32, lower: u32) -> f32 {
    let deep = upper >> 10 == 0;
    let high = if deep {
        upper << 10 | lower >> 22
    } else {
        upper >> 8
    };
    let low = if deep {
        lower << 1
    } else {
        upper << 15 | lower >> 17
    };
    let unit = if deep {
        TWO_TO_MINUS_65
    } else {
        TWO_TO_MINUS_47
    };
    sum(high, low | 1) * unit
}

/// 2²³·`high` and the lower 23 bits of `low`, rounded once.
#[inline(always)]
fn sum(high: u32, low: u32) -> f32 {
    const HIGH: u32 = carrier(23);
    const LOW: u32 = carrier(0);
    // Both at once: the only sum that rounds is the last.
    const CARRIERS: f32 = f32::from_bits(HIGH) + f32::from_bits(LOW);
    let high = f32::from_bits(HIGH | high) - CARRIERS;
    high + f32::from_bits(LOW | low & 0x7F_FFFF)
}

/// The lower tail (2n + 1)·2⁻³³ and the upper one, each rounded once: never zero, and 1 is not
/// passed.
#[inline(always)]
pub(crate) fn tails_of_half(n: u32, code: Code) -> [f32; 2] {
    match code {
        _ if !WORDS_OF_64 => apart(n, nearer),
        Code::Scalar => converted(n),
        Code::Vector => summed(n),
    }
}

/// By 32-bit integers: the tails of a count n in the order of the lower ones, of which `nearer` is
/// that of a count below 2³¹.
///
/// The farther is put together from its bits, since a difference may be a routine: half a place is
/// added and cut off, of which what is odd leaves no tie.
#[inline(always)]
pub(crate) fn apart(n: u32, nearer: impl Fn(u32) -> f32) -> [f32; 2] {
    let is_upper = n >> 31 != 0;
    let n = if is_upper { !n } else { n };
    let p = nearer(n);
    let halves = (1u32 << 24).wrapping_sub(n >> 7);
    let q = f32::from_bits((halves >> 1).wrapping_add(0.5f32.to_bits()));
    if is_upper { [q, p] } else { [p, q] }
}

/// (2n + 1)·2⁻³³ for n < 2³¹.
#[inline(always)]
fn nearer(n: u32) -> f32 {
    down::<33>((n << 1 | 1) as f32)
}

#[inline(always)]
fn converted(n: u32) -> [f32; 2] {
    let odd = i64::from(n) << 1 | 1;
    [odd, (1 << 33) - odd].map(|n| down::<33>(n as f32))
}

#[inline(always)]
fn summed(n: u32) -> [f32; 2] {
    const HIGH: u32 = carrier(17 - 33);
    const LOW: u32 = carrier(-33);
    const CARRIERS: f32 = f32::from_bits(HIGH) + f32::from_bits(LOW);
    let high = f32::from_bits(HIGH | n >> 16);
    let low = f32::from_bits(LOW | (n << 1 | 1) & 0x1_FFFF);
    [(high - CARRIERS) + low, (CARRIERS + 1.0 - high) - low]
}

/// x·2⁻ᴺ for |x| ≥ 1: in the exponent where a product may be a routine.
#[inline(always)]
pub(crate) fn down<const N: i32>(x: f32) -> f32 {
    if WORDS_OF_64 {
        x * power_of_two(-N)
    } else {
        f32::from_bits(x.to_bits().wrapping_sub((N as u32) << 23))
    }
}

/// [`tail`] by 32-bit integers alone.
#[inline(always)]
fn assembled(n: u64) -> f32 {
    let odd = (n << 1) | 1;
    let zeros = odd.leading_zeros();
    let leading = odd << zeros;
    // The last bit stands for all that follow it: they decide only whether half a place is a tie.
    let top = (leading >> 32) as u32 | u32::from(leading as u32 != 0);
    let significand = top >> 8;
    let up = ((top & 0xFF) + 0x7F + (significand & 1)) >> 8;
    // The significand's leading one counts as one in the exponent, and its overflow as another.
    f32::from_bits(((124 - zeros) << 23) + significand + up)
}

/// (q, n): a uniform azimuth as q quarters and n·2⁻³³ turns, |n| < 2³⁰, n odd.
#[inline(always)]
pub(crate) fn parts_of_turn(bits: u32) -> (u32, i32) {
    // What is left of the quarters are the lower 30 bits, as a signed number.
    (quadrant(bits), ((bits << 2) as i32 >> 1) | 1)
}

#[inline(always)]
fn quadrant(bits: u32) -> u32 {
    bits.wrapping_add(1 << 29) >> 30
}

/// (q, x): the same azimuth as q quarters and x turns, |x| ≤ ⅛, x rounded once.
#[inline(always)]
pub(crate) fn turn(bits: u32) -> (u32, f32) {
    // Four quarters, and twice the half of a unit that a word stands for.
    (quadrant(bits), down::<34>((bits << 2 | 2) as i32 as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All ways of [`tail`] against the compiler's unsigned conversion: every count of leading
    /// zeros, and patterns of low bits around the tie of each.
    #[test]
    fn tails_are_rounded_once() {
        let mut noise = 0x9E37_79B9_7F4A_7C15u64;
        for length in 0..=63 {
            let lead: u64 = (1 << length) >> 1;
            for shift in 0..=length {
                for pattern in 0..16 {
                    noise = noise.wrapping_mul(0xD134_2543_DE82_EF95).wrapping_add(1);
                    let top = u64::MAX >> 1;
                    for low in [
                        pattern << shift,
                        (1 << shift) - 1,
                        noise >> 1,
                        noise >> 1 << shift,
                    ] {
                        for n in [lead | low, lead | low.wrapping_sub(1), lead ^ low] {
                            let n = n & top & (top >> (63 - length));
                            let expected = (2 * n + 1) as f32 * 0.5f32.powi(65);
                            for found in [
                                branched(n),
                                selected((n >> 32) as u32, n as u32),
                                assembled(n),
                            ] {
                                assert_eq!(found.to_bits(), expected.to_bits(), "{n:#x}");
                            }
                        }
                    }
                }
            }
        }
    }

    fn same_tails(n: u32) {
        let odd = 2.0 * f64::from(n) + 1.0;
        let expected = [odd, 0.5f64.powi(-33) - odd].map(|n| (n * 0.5f64.powi(33)) as f32);
        for found in [apart(n, nearer), converted(n), summed(n)] {
            assert_eq!(
                found.map(f32::to_bits),
                expected.map(f32::to_bits),
                "{n:#x}"
            );
        }
    }

    #[test]
    fn tails_of_halves_are_rounded_once() {
        (0..=u32::MAX).step_by(997).for_each(same_tails);
        for shift in 0..32 {
            for near in 0..1 << 10 {
                for n in [near << shift, ((1 << shift) - 1) ^ near] {
                    same_tails(n);
                    same_tails(!n);
                }
            }
        }
    }

    fn same_turn(bits: u32) {
        let ((quarter, x), (quarters, n)) = (turn(bits), parts_of_turn(bits));
        let expected = (f64::from(n) * 0.5f64.powi(33)) as f32;
        assert_eq!(
            (quarter, x.to_bits()),
            (quarters, expected.to_bits()),
            "{bits:#x}"
        );
    }

    #[test]
    fn turns_are_rounded_once() {
        (0..=u32::MAX).step_by(997).for_each(same_turn);
        for eighth in 0..8u32 {
            for near in 0..1 << 12 {
                same_turn((eighth << 29).wrapping_add(near));
                same_turn((eighth << 29).wrapping_sub(near));
            }
        }
    }
}
