//! The angle of a direction: one quotient with its rounding error, one odd polynomial.

use super::pair::Pair;
use super::poly::horner;
use crate::CosSin;
use crate::arithmetic::native::format::Native;

/// θ of a unit vector with cos θ ≥ 0. Error < 1 ulp.
#[inline(always)]
pub(crate) fn of_direction<T: Native>(at: CosSin<T>) -> T {
    let (y, x) = (at.sin.abs(), at.cos);
    let steep = y > x;
    let (small, large) = if steep { (x, y) } else { (y, x) };
    place(small, large, steep, false).copysign(at.sin)
}

/// atan2(y, x) with std's conventions for ±0, ±∞ and NaN. Error < 1 ulp.
#[inline(always)]
pub(crate) fn atan2<T: Native>(y: T, x: T) -> T {
    let (a, b) = (y.abs(), x.abs());
    let steep = a > b;
    let (small, large) = (T::select(steep, b, a), T::select(steep, a, b));
    // Up: a residual must not underflow. Down: a sum must not overflow. Neither rounds.
    let down = T::select(small > T::ONE, T::QUARTER, T::ONE);
    let scale = T::select(large < T::ONE, T::CBRT_UP, down);
    // Two zeros have the angle 0; of two infinities only equality is known.
    let equal = a == b;
    let one = T::select(a == T::ZERO, T::ZERO, T::ONE);
    let small = T::select(equal, one, small * scale);
    let large = T::select(equal, T::ONE, large * scale);
    place(small, large, steep, T::ONE.copysign(x) < T::ZERO).copysign(y)
}

/// The angle whose tangent is small/large, or large/small where `steep`, or π less that `behind`.
///
/// Measured from the nearest multiple of π/4 its tangent is small/large where that is ≤ ½, else
/// (large − small)/(large + small) ≤ ⅓, whose numerator is exact. The quotient keeps its rounding
/// error, so that the sum with the multiple of π/4 is rounded once.
#[inline(always)]
fn place<T: Native>(small: T, large: T, steep: bool, behind: bool) -> T {
    let bent = small > large * T::HALF;
    let top = T::select(bent, large - small, small);
    let bottom = Pair::fast_two_sum(large, T::select(bent, small, T::ZERO));
    let q = top / bottom.hi;
    let v = q * q;
    // top − q·bottom, from halves whose products are exact.
    let (q_lead, bottom_lead) = (q.leading_half(), bottom.hi.leading_half());
    let bottom_trail = (bottom.hi - bottom_lead) + bottom.lo;
    let residual = (top - q_lead * bottom_lead) - q_lead * bottom_trail - (q - q_lead) * bottom.hi;
    // d atan q / dq = 1/(1 + q²). A negligible q needs no more digits, and may have underflowed.
    let rest = residual / (bottom.hi + bottom.hi * v);
    let rest = if q < T::NEGLIGIBLE { T::ZERO } else { rest };
    let rest = rest + q * v * horner(v, T::TABLE.atan);

    let eighths = i16::from(bent);
    let eighths = if steep { 2 - eighths } else { eighths };
    let eighths = T::int(if behind { 4 - eighths } else { eighths });
    let back = bent ^ steep ^ behind;
    let (q, rest) = (q.negate_if(back), rest.negate_if(back));
    // π/4 with few enough leading digits that its multiples are exact.
    let eighth = T::CONSTANTS.half_pi.half();
    let lead = eighth.hi.leading_half();
    let trail = (eighth.hi - lead) + eighth.lo;
    let angle = Pair::fast_two_sum(eighths * lead, q);
    angle.hi + (angle.lo + (eighths * trail + rest))
}

#[cfg(test)]
mod tests {
    use super::atan2;

    /// Every pairing of zeros, infinities, NaN and the ends of the range, as std has it.
    #[test]
    fn conventions() {
        let ends = [0.0, 5e-324, 1e-310, 1.0, 1.5, f64::MAX, f64::INFINITY];
        let all = ends.iter().flat_map(|&v| [v, -v]).chain([f64::NAN]);
        for (y, x) in all.clone().flat_map(|y| all.clone().map(move |x| (y, x))) {
            let (own, std) = (atan2(y, x), y.atan2(x));
            let near = (own - std).abs() <= std.abs() * f64::EPSILON;
            let same = own.is_nan() == std.is_nan()
                && (own.is_nan() || near && own.is_sign_negative() == std.is_sign_negative());
            assert!(same, "atan2({y:e}, {x:e}): {own:e}, std {std:e}");
        }
    }

    #[test]
    fn f32_against_f64() {
        let mut bits = 1u64;
        for _ in 0..2_000_000 {
            bits = bits.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(1);
            let y = f32::from_bits((bits >> 32) as u32 & 0x7FFF_FFFF);
            let x = y * (2.0 * ((bits >> 16) as u32 as f32 * 0.5f32.powi(31)) - 2.0);
            let truth = f64::from(y).atan2(f64::from(x));
            let ulp = (truth as f32).to_bits();
            let ulp = f64::from(f32::from_bits(ulp + 1)) - f64::from(f32::from_bits(ulp));
            let error = (f64::from(atan2(y, x)) - truth).abs() / ulp;
            assert!(
                !x.is_finite() || error < 1.0,
                "atan2({y:e}, {x:e}): {error} ulp"
            );
        }
    }
}
