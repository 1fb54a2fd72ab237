//! Probabilities told by comparisons that suit the target.
//!
//! On 64-bit processors loops of vectors want no jump; on boards a comparison of numbers is a
//! routine, one of patterns is not. A NaN may be any.

use crate::scalar::one_by_one;

const ONE: u32 = 1.0f32.to_bits();

/// Of −0, and of what is no probability.
#[cold]
fn zero_or_nan(x: f32) -> f32 {
    if x == 0.0 { 0.0 } else { f32::NAN }
}

/// [`Scalar::probability`].
///
/// Not or-ed with the comparison's ones: where registers are short a compiler makes a vector of
/// ones anew for each element, which on AVX-512 waits for what its register held (`Disk` took
/// twice the time).
#[inline(always)]
pub(crate) fn of_f32<const SELECTS: bool>(x: f32) -> f32 {
    const NAN: u32 = f32::NAN.to_bits();
    if SELECTS {
        let bits = (x + 0.0).to_bits();
        f32::from_bits(bits | if bits > ONE { NAN } else { 0 })
    } else if x.to_bits() <= ONE {
        x
    } else {
        zero_or_nan(x)
    }
}

/// [`Scalar::probabilities`]: the comparison's ones are a NaN.
///
/// Not by an array: two `f32` in one go as an integer of 64 bits, which halves the vectors of a
/// loop over pairs.
#[inline(always)]
pub(crate) fn pair_of_f32<const SELECTS: bool>(a: f32, b: f32) -> (f32, f32) {
    if SELECTS {
        let (a, b) = ((a + 0.0).to_bits(), (b + 0.0).to_bits());
        let ones = u32::from((a > ONE) | (b > ONE)).wrapping_neg();
        return (f32::from_bits(a | ones), f32::from_bits(b));
    }
    let a = of_f32::<SELECTS>(a);
    if b.to_bits() <= ONE {
        (a, b)
    } else {
        (a + zero_or_nan(b), 0.0)
    }
}

/// The same, by numbers: SSE2 does not compare integers of 64 bits.
#[expect(clippy::manual_range_contains, reason = "a range's jumps are slower")]
#[inline(always)]
pub(crate) fn pair_of_f64<const SELECTS: bool>(a: f64, b: f64) -> (f64, f64) {
    if !SELECTS {
        return one_by_one(a, b);
    }
    let is_none = !((a >= 0.0) & (a <= 1.0) & (b >= 0.0) & (b <= 1.0));
    let ones = u64::from(is_none).wrapping_neg();
    (f64::from_bits((a + 0.0).to_bits() | ones), b + 0.0)
}

#[cfg(test)]
mod tests {
    use super::{of_f32, pair_of_f32, pair_of_f64};
    use crate::scalar::{Scalar, one_by_one};

    /// −0 as 0, of numbers that are none only that they are none.
    fn agree<T: Scalar + core::fmt::Debug>(a: T, b: T, got: (T, T)) {
        let is = |x: T| x >= T::ZERO && x <= T::ONE;
        if is(a) && is(b) {
            assert_eq!(got, (a.abs(), b.abs()), "{a:?}, {b:?}");
            assert_eq!(got.0.sign_bit() | got.1.sign_bit(), 0, "{a:?}, {b:?}");
        } else {
            assert!(got.0.is_nan(), "{a:?}, {b:?}: {got:?}");
        }
    }

    #[test]
    fn either_way() {
        let beyond = [1.0f32.next_up(), 2.0, f32::MAX, f32::INFINITY, f32::NAN];
        let within = [0.0, f32::from_bits(1), 0.5, 1.0f32.next_down(), 1.0];
        let all = || within.into_iter().chain(beyond).flat_map(|x| [x, -x]);
        for a in all() {
            agree(a, 0.0, (of_f32::<true>(a), 0.0));
            agree(a, 0.0, (of_f32::<false>(a), 0.0));
            for b in all() {
                agree(a, b, pair_of_f32::<true>(a, b));
                agree(a, b, pair_of_f32::<false>(a, b));
                let (a, b) = (f64::from(a), f64::from(b));
                agree(a, b, pair_of_f64::<true>(a, b));
                agree(a, b, one_by_one(a, b));
            }
        }
        for x in [
            f64::from_bits(1),
            1.0f64.next_down(),
            1.0f64.next_up(),
            1e300,
        ] {
            for (a, b) in [(x, 0.5), (0.5, x), (-x, 0.5), (0.5, -x)] {
                agree(a, b, pair_of_f64::<true>(a, b));
            }
        }
    }
}
