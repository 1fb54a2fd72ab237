//! Shifting a word up until its top bit is set.

/// (x·2ˢ, s) with x·2ˢ ≥ 2³¹, for x > 0; for 0, (0, 31).
#[inline(always)]
pub(crate) fn normal(x: u32) -> (u32, u32) {
    normal_below::<32>(x)
}

/// The same where s < `LIMIT` is known.
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn normal_below<const LIMIT: u32>(x: u32) -> (u32, u32) {
    let shift = (x | 1).leading_zeros();
    debug_assert!(shift < LIMIT);
    (x << shift, shift)
}

/// The same where counting zeros is a call: five comparisons at most.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
pub(crate) use by_steps as normal_below;

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn by_steps<const LIMIT: u32>(x: u32) -> (u32, u32) {
    let (x, shift) = step::<16, LIMIT>(x, 0);
    let (x, shift) = step::<8, LIMIT>(x, shift);
    let (x, shift) = step::<4, LIMIT>(x, shift);
    let (x, shift) = step::<2, LIMIT>(x, shift);
    step::<1, LIMIT>(x, shift)
}

/// Up by `STEP` if that many bits are free. One choice for both, which costs a branch each on a
/// Cortex-M0.
#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
fn step<const STEP: u32, const LIMIT: u32>(x: u32, shift: u32) -> (u32, u32) {
    let up = if STEP < LIMIT && x >> (32 - STEP) == 0 {
        STEP
    } else {
        0
    };
    (x << up, shift | up)
}

/// The top 32 bits of x·2ˢ with the top bit set, and s, for x > 0; (0, 63) for 0.
#[inline(always)]
pub(crate) fn normal_long(x: u64) -> (u32, u32) {
    let (high, low) = ((x >> 32) as u32, x as u32);
    let (leading, next, more) = if high == 0 {
        (low, 0, 32)
    } else {
        (high, low, 0)
    };
    let (m, shift) = normal(leading);
    (
        m | ((next >> 1) >> 31u32.wrapping_sub(shift)),
        shift.wrapping_add(more),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_shift_as_counted_zeros_do() {
        for i in 0..32 {
            for x in [1 << i, (1u32 << i) | 1, u32::MAX >> i] {
                assert_eq!(by_steps::<32>(x), normal(x), "{x:#x}");
                if i < 16 {
                    let x = x | 1 << (31 - i);
                    assert_eq!(by_steps::<16>(x), normal(x), "{x:#x}");
                }
                if i < 4 {
                    let x = x | 1 << (31 - i);
                    assert_eq!(by_steps::<4>(x), normal(x), "{x:#x}");
                }
            }
        }
        assert_eq!(by_steps::<32>(0), normal(0));
    }
}
