//! Heuristics of multiple importance sampling that survive zero and infinite densities.

use crate::number::Real;

/// a/(a + b): the balance heuristic's weight of a sample drawn with density `a` where the other
/// strategy has density `b` (each times its number of samples).
///
/// a = ∞ gives 1, both ∞ ½, both 0 gives 0 (no strategy could draw it); a + b cannot overflow on
/// the way. NaN or a negative density gives NaN. Error < 3 ulp. Source: Veach, *Robust Monte
/// Carlo Methods*, 1997, section 9.2.
///
/// ```
/// assert_eq!(coslobe::balance_heuristic(3.0f32, 1.0), 0.75);
/// assert_eq!(coslobe::balance_heuristic(f64::INFINITY, 1.0), 1.0);
/// ```
#[inline]
pub fn balance_heuristic<T: Real>(a: T, b: T) -> T {
    combine(a, b, |ratio| ratio)
}

/// a²/(a² + b²): the power heuristic with exponent 2. Limits and errors as
/// [`balance_heuristic`] (error < 4 ulp); neither square overflows or underflows on the way.
#[inline]
pub fn power_heuristic<T: Real>(a: T, b: T) -> T {
    combine(a, b, |ratio| ratio * ratio)
}

/// 1/(1 + f(b/a)) or its mirror image, whichever has a ratio ≤ 1.
#[inline(always)]
fn combine<T: Real>(a: T, b: T, f: impl Fn(T) -> T) -> T {
    if !(a >= T::ZERO && b >= T::ZERO) {
        return T::NAN;
    }
    let (a, b) = (a.abs(), b.abs());
    if a == b {
        return if a == T::ZERO { T::ZERO } else { T::HALF };
    }
    if b < a {
        T::ONE / (T::ONE + f(b / a))
    } else {
        let ratio = f(a / b);
        ratio / (T::ONE + ratio)
    }
}
