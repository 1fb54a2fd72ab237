//! Horner's rule in three accuracies: the further a coefficient, the smaller its share of the sum.

use super::arith::Double;
use super::arith::{add_raw, mul_raw, normalise};
use crate::arithmetic::native::float::Float;
use crate::arithmetic::native::poly::horner;

/// A power series whose terms fall in size.
pub(crate) struct Series {
    /// Coefficients of the terms summed with all digits.
    pub(crate) full: &'static [Double],
    /// Coefficients after which a product may be off by 2⁻⁷⁶ of itself.
    pub(crate) middle: &'static [Double],
    /// Coefficients of the terms for which f64 is enough.
    pub(crate) plain: &'static [f64],
}

impl Series {
    /// Σ cᵢ xⁱ, not normalised.
    #[inline(always)]
    pub(crate) fn sum(&self, x: Double) -> Double {
        let x_head = x.hi.leading_half();
        let x_rest = (x.hi - x_head) + x.lo;
        let mut sum = Double::from_f64(horner(x.hi, self.plain));
        for &c in self.middle.iter().rev() {
            // The leading halves have an exact product.
            let head = sum.hi.leading_half();
            let rest = (sum.hi - head) + sum.lo;
            let product = Double {
                hi: head * x_head,
                lo: rest * x.hi + head * x_rest,
            };
            sum = add_raw(c, product);
        }
        sum = normalise(sum);
        for &c in self.full.iter().rev() {
            sum = add_raw(c, mul_raw(sum, x));
        }
        sum
    }
}
