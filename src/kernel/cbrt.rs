//! Cube root: an integer guess, Halley steps, and a last step from a shortened iterate.

use super::pair::Pair;
use crate::number::native::Native;

/// Adds what rounding took from a cube root t = ∛x.
#[inline]
pub(crate) fn refine<T: Native>(t: T, x: T) -> Pair<T> {
    let square = Pair::product(t, t);
    let cube = square.mul(Pair::exact(t));
    let rest = ((x - cube.hi) - cube.lo) / (square.hi * T::int(3));
    Pair::fast_sum(t, rest)
}

/// ∛(k·x) for x ≥ 0 and moderate k > 0; subnormal x keeps its precision. Error < 1 ulp.
///
/// The last iterate is cut to half its digits, so that its square is exact and the residual
/// k·x/t² − t carries no error of its own.
#[inline]
pub(crate) fn cbrt_times<T: Native>(k: Pair<T>, x: T) -> T {
    let tiny = x < T::CBRT_TINY;
    let x = if tiny { x * T::CBRT_UP } else { x };
    let y = x * k.hi + x * k.lo;
    let mut t = y.cbrt_guess();
    for _ in 0..T::CBRT_STEPS {
        let cube = t * t * t;
        // The ratio first: t·(y − t³) alone could underflow.
        t = t + t * ((y - cube) / (cube + cube + y));
    }
    let t = t.leading_half();
    let r = y / (t * t);
    let root = t + t * ((r - t) / (t + t + r));
    let root = if tiny { root * T::CBRT_DOWN } else { root };
    if x == T::ZERO { x } else { root }
}
