//! Shifting a word up until its top bit is set.

/// (x·2ˢ, s) with x·2ˢ ≥ 2³¹, for x > 0; for 0, (0, 31).
#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn normal(x: u32) -> (u32, u32) {
    let shift = (x | 1).leading_zeros();
    (x << shift, shift)
}

/// The same where counting zeros is a call: five comparisons.
#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
pub(crate) use by_steps as normal;

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
pub(crate) fn by_steps(mut x: u32) -> (u32, u32) {
    let mut shift = 0;
    for step in [16, 8, 4, 2, 1] {
        if x >> (32 - step) == 0 {
            x <<= step;
            shift += step;
        }
    }
    (x, shift)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_shift_as_counted_zeros_do() {
        for i in 0..32 {
            for x in [1 << i, (1u32 << i) | 1, u32::MAX >> i] {
                assert_eq!(by_steps(x), normal(x), "{x:#x}");
            }
        }
        assert_eq!(by_steps(0), normal(0));
    }
}
