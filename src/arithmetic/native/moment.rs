//! ∫₀^{π/2} cosⁿθ dθ and ∫₀^{π/2} θ cosⁿθ dθ for real n ≥ 1.

use super::pair::Pair;
use super::poly::horner;
use crate::arithmetic::native::format::Native;

/// (∫ cosⁿθ, ∫ θ cosⁿθ): asymptotic series at n + 2m ≥ 32, then down by the recurrences.
pub(crate) fn cosine_integrals<T: Native>(n: T) -> (T, T) {
    let steps = if n < T::int(32) {
        ((T::int(33) - n).to_u32() / 2).wrapping_add(1)
    } else {
        0
    };
    let mut top = n + T::int((steps as i16).wrapping_mul(2));
    // √(π/2t) (1 + a₁/m² + …), t = n + ½, m = t/2.
    let m = (top + T::HALF) * T::HALF;
    let shape = horner(T::ONE / m / m, T::TABLE.cosine_integral);
    let plain = (T::CONSTANTS.half_pi.hi / (top + T::HALF)).sqrt() * shape;
    // Σ bⱼ/nʲ.
    let recip = T::ONE / top;
    let weighted = recip * horner(recip, T::TABLE.angle_integral);
    let (mut plain, mut weighted) = (Pair::exact(plain), Pair::exact(weighted));
    for _ in 0..steps {
        let ratio = Pair::exact(top).div(Pair::two_sum(top, -T::ONE));
        let square = Pair::exact(T::ONE).div(Pair::two_prod(top, top));
        plain = plain.mul(ratio);
        weighted = weighted.add(square).mul(ratio);
        top = top - T::int(2);
    }
    (plain.value(), weighted.value())
}
