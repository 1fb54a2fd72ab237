//! A uniform number of `f32` from 63 random bits.

const TWO_TO_MINUS_64: f32 = f32::from_bits((127 - 64) << 23);

/// (2n + 1)·2⁻⁶⁵ for n < 2⁶³, rounded to nearest: never zero; ½ is reached and not passed.
#[inline(always)]
pub(crate) fn odd_multiple(n: u64) -> f32 {
    // One instruction on 64-bit processors, a routine of the compiler's on smaller ones.
    if cfg!(target_pointer_width = "64") {
        converted(n)
    } else {
        assembled(n)
    }
}

/// [`odd_multiple`] by the compiler's conversion.
///
/// Signed, since an unsigned conversion is a branch on the top bit on many processors. From 2⁴⁰ on
/// the last bit lies below the digits kept and stands for itself and the ½, which is never zero.
#[inline(always)]
fn converted(n: u64) -> f32 {
    let half_more = if n >> 40 != 0 {
        (n | 1) as i64 as f32
    } else {
        (2 * n + 1) as i64 as f32 * 0.5
    };
    half_more * TWO_TO_MINUS_64
}

/// [`odd_multiple`] by 32-bit integers alone.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Both ways of [`odd_multiple`] against the compiler's unsigned conversion: every count of leading zeros,
    /// and patterns of low bits around the tie of each.
    #[test]
    fn odd_multiples_are_rounded_once() {
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
                            let expected = (2 * n + 1) as f32 * (TWO_TO_MINUS_64 / 2.0);
                            for found in [converted(n), assembled(n)] {
                                assert_eq!(found.to_bits(), expected.to_bits(), "{n:#x}");
                            }
                        }
                    }
                }
            }
        }
    }
}
