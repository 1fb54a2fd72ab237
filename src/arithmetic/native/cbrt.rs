//! Cube root without a division: from an integer guess of 1/∛x, and a last step from a shortened
//! ∛x.

use super::pair::Pair;
use crate::arithmetic::native::format::Native;

/// Adds what rounding took from a cube root t = ∛x.
#[inline(always)]
pub(crate) fn refine<T: Native>(t: T, x: T) -> Pair<T> {
    let square = Pair::two_prod(t, t);
    let cube = square.mul(Pair::from_value(t));
    let rest = ((x - cube.hi) - cube.lo) / (square.hi * T::int(3));
    Pair::fast_two_sum(t, rest)
}

/// ∛(y·`CBRT_DOWN`³), for y = 0 and for normal y far from underflow and overflow.
///
/// With e = 1 − y·r³, r(1 + e/3 + 2e²/9 + 14e³/81) is 1/∛y to the fourth power of r's error. The
/// last iterate t is cut to half its digits, so that its square is exact, and with s the
/// correction (y − t³)/(3y^⅔) the root is t + s + s²/t + …. The square is halved once more: y − t³
/// is rounded once.
#[inline(always)]
fn scaled<T: Native>(y: T) -> T {
    let third = T::CBRT_THIRD;
    let mut r = y.cbrt_recip_guess();
    let e = T::ONE - (y * r) * (r * r);
    let bend = T::CBRT_SECOND + e * T::CBRT_FOURTH;
    r = r + (r * e) * (third + e * bend);
    for _ in 0..T::CBRT_STEPS {
        let e = T::ONE - (y * r) * (r * r);
        r = r + (r * e) * third;
    }
    let square = r * r;
    // Raised by half the place that it is cut at: cutting then rounds.
    let t = (y * T::CBRT_RAISE * square).leading_half();
    let high = (t * t).leading_half();
    let low = t * t - high;
    let s = ((y - high * t) - low * t) * (square * third);
    (t + (s + s * s * r)) * T::CBRT_DOWN
}

/// ∛x for x ≥ 0, at most moderately large. Proved: error < 0.75 ulp (f32), < 0.84 (f64).
#[inline(always)]
pub(crate) fn cbrt<T: Native>(x: T) -> T {
    // Scaled up always, so that subnormal numbers need no branch.
    scaled(x * T::CBRT_UP)
}

/// ∛(k·x) for x ≥ 0 and moderate k > 0; rounding y adds up to ⅔ ulp to the error.
#[inline(always)]
pub(crate) fn cbrt_times<T: Native>(k: Pair<T>, x: T) -> T {
    scaled(x * (k.hi * T::CBRT_UP) + x * (k.lo * T::CBRT_UP))
}

#[cfg(test)]
mod tests {
    use super::cbrt;

    #[test]
    fn f32_keeps_the_proved_bound() {
        for bits in (1f32.to_bits()..8f32.to_bits()).step_by(5) {
            let x = f32::from_bits(bits);
            // Between 1 and 2.
            let off = (f64::from(cbrt(x)) - libm::cbrt(x.into())).abs();
            assert!(off < 0.75 * f64::from(f32::EPSILON), "{bits:#x}");
        }
    }
}
