//! Powers by a logarithm and an exponential, for the arithmetics whose numbers carry all the
//! digits that they need.

use super::kernel::Kernel;
use crate::CosSin;

/// An arithmetic whose numbers are wide enough to be multiplied by an exponent.
pub(crate) trait Logarithmic: Kernel<Wide = Self> {
    /// k·ln cos θ for cos θ > 0.
    fn ln_cos_power(k: Self, at: CosSin<Self>) -> Self;
    /// c·eᵃ.
    fn exp_times(a: Self, c: Self) -> Self;
    /// 1 − eᵃ for a ≤ 0.
    fn one_minus_exp(a: Self) -> Self;
}

/// `scale`·cosᵏθ.
#[inline]
pub(crate) fn power_times<W: Logarithmic>(k: W, at: CosSin<W>, scale: W) -> W {
    if at.cos > W::ZERO {
        W::exp_times(W::ln_cos_power(k, at), scale)
    } else if k == W::ZERO {
        scale
    } else if k > W::ZERO {
        W::ZERO
    } else {
        W::INFINITY
    }
}

/// k·ln cos θ + ln sin θ + c.
#[inline]
pub(crate) fn ln_power_times_sine<W: Logarithmic>(k: W, at: CosSin<W>, c: W) -> W {
    let power = if at.cos > W::ZERO {
        W::ln_cos_power(k, at)
    } else {
        -W::INFINITY
    };
    if at.sin > W::ZERO && power.is_finite() {
        c + power + W::ln_wide(at.sin)
    } else {
        -W::INFINITY
    }
}

/// (1 − cosⁿθ, cosⁿθ).
#[inline]
pub(crate) fn power_tails<W: Logarithmic>(n: W, at: CosSin<W>) -> (W, W) {
    if at.cos > W::ZERO {
        let a = W::ln_cos_power(n, at);
        (W::one_minus_exp(a), W::exp_times(a, W::ONE))
    } else {
        (W::ONE, W::ZERO)
    }
}
