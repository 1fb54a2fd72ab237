//! The high half of a product.

/// A Cortex-M0 multiplies 32 bits by 32 to 32 and calls a routine for 64. `rustc` shows no name
/// for that; among Arm targets, lacking atomic swaps goes with it. (ARMv5 lacks them too: there
/// this costs time, no bits.)
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
mod of {
    /// ⌊a b / 2³²⌋ from four products of 16 bits.
    #[inline(always)]
    pub(crate) fn mul_high(a: u32, b: u32) -> u32 {
        super::by_halves(a, b)
    }

    /// ⌊a b / 2³²⌋ of signed numbers.
    #[inline(always)]
    pub(crate) fn mul_high_signed(a: i32, b: i32) -> i32 {
        super::by_halves_signed(a, b)
    }
}

#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
mod of {
    /// ⌊a b / 2³²⌋: one instruction where there is a long multiply.
    #[inline(always)]
    pub(crate) fn mul_high(a: u32, b: u32) -> u32 {
        ((u64::from(a).wrapping_mul(u64::from(b))) >> 32) as u32
    }

    /// ⌊a b / 2³²⌋ of signed numbers.
    #[inline(always)]
    pub(crate) fn mul_high_signed(a: i32, b: i32) -> i32 {
        ((i64::from(a).wrapping_mul(i64::from(b))) >> 32) as i32
    }
}

pub(crate) use of::{mul_high, mul_high_signed};

/// The low half of `b` is taken as a signed number, so that LLVM does not find a long product in
/// this and call the routine after all.
#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
fn by_halves(a: u32, b: u32) -> u32 {
    let (a1, a0, b0) = (a >> 16, a & 0xFFFF, i32::from(b as i16));
    let b1 = (b >> 16).wrapping_add((b >> 15) & 1);
    let middle = (a1 as i32)
        .wrapping_mul(b0)
        .wrapping_add(((a0 as i32).wrapping_mul(b0)) >> 16);
    let other = a0.wrapping_mul(b1).wrapping_add(middle as u32 & 0xFFFF);
    (a1.wrapping_mul(b1))
        .wrapping_add_signed(middle >> 16)
        .wrapping_add(other >> 16)
}

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
fn by_halves_signed(a: i32, b: i32) -> i32 {
    let (a1, a0, b1, b0) = (a >> 16, a & 0xFFFF, b >> 16, b & 0xFFFF);
    let lowest = (((a0 as u32).wrapping_mul(b0 as u32)) >> 16) as i32;
    let middle = a1.wrapping_mul(b0).wrapping_add(lowest);
    let other = a0.wrapping_mul(b1).wrapping_add(middle & 0xFFFF);
    a1.wrapping_mul(b1)
        .wrapping_add(middle >> 16)
        .wrapping_add(other >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_give_the_bits_of_the_long_product() {
        let corners = [
            0,
            1,
            0x7FFF,
            0x8000,
            0xFFFF,
            0x1_0000,
            0x7FFF_FFFF,
            0x8000_0000,
            u32::MAX,
        ];
        let scattered = (1..200u32).map(|i| i.wrapping_mul(0x9E37_79B9));
        let values: [u32; 208] = {
            let mut out = [0; 208];
            for (to, from) in out.iter_mut().zip(corners.into_iter().chain(scattered)) {
                *to = from;
            }
            out
        };
        for a in values {
            for b in values {
                assert_eq!(by_halves(a, b), mul_high(a, b), "{a:#x} {b:#x}");
                let (a, b) = (a as i32, b as i32);
                assert_eq!(
                    by_halves_signed(a, b),
                    mul_high_signed(a, b),
                    "{a:#x} {b:#x}"
                );
            }
        }
    }
}
