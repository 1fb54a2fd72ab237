//! ∫₀^{π/2} cosⁿθ dθ and ∫₀^{π/2} θ cosⁿθ dθ for real n ≥ 1.
//!
//! Method: asymptotic series at n + 2m ≥ 32, then down by the recurrences, all in pairs: the
//! variance of θ is a difference in which three bits of them cancel.

use super::format::Native;
use super::pair::Pair;
use super::poly::horner;

/// √x.
fn root<T: Native>(x: Pair<T>) -> Pair<T> {
    let root = x.hi.sqrt();
    let square = Pair::two_prod(root, root);
    let rest = ((x.hi - square.hi) - square.lo) + x.lo;
    Pair::fast_two_sum(root, rest / (root + root))
}

/// √(π/2t) (1 + a₁/m² + …), t = n + ½, m = t/2.
fn plain<T: Native>(n: Pair<T>) -> Pair<T> {
    let t = n.add(Pair::from_value(T::HALF));
    let m = t.hi * T::HALF;
    let square = T::ONE / m / m;
    let [first, rest @ ..] = T::TABLE.cosine_integral else {
        return n; // the series has terms
    };
    let shape = Pair::fast_two_sum(*first, square * horner(square, rest));
    root(T::CONSTANTS.half_pi.div(t)).mul(shape)
}

/// Σ bⱼ/nʲ.
fn weighted<T: Native>(n: Pair<T>) -> Pair<T> {
    let recip = Pair::from_value(T::ONE).div(n);
    let bend = Pair::ratio(-2, 3).mul(recip);
    let tail = recip.hi * recip.hi * horner(recip.hi, T::TABLE.angle_integral);
    recip.mul(
        Pair::from_value(T::ONE)
            .add(bend)
            .add(Pair::from_value(tail)),
    )
}

/// (∫ cosⁿθ, ∫ θ cosⁿθ).
pub(crate) fn cosine_integrals<T: Native>(n: Pair<T>) -> (Pair<T>, Pair<T>) {
    let steps = if n.hi < T::int(32) {
        ((T::int(33) - n.hi).to_u32() / 2).wrapping_add(1)
    } else {
        0
    };
    let mut top = n.add(Pair::from_value(T::int((steps as i16).wrapping_mul(2))));
    let (mut plain, mut weighted) = (plain(top), weighted(top));
    for _ in 0..steps {
        let ratio = top.div(top.add(Pair::from_value(-T::ONE)));
        let square = Pair::from_value(T::ONE).div(top.mul(top));
        plain = plain.mul(ratio);
        weighted = weighted.add(square).mul(ratio);
        top = top.add(Pair::from_value(T::int(-2)));
    }
    (plain, weighted)
}
