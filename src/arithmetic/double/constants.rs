//! The laws' constants, which a pair of `f64` holds to all digits.

use super::arith::Double;
use crate::arithmetic::constants::Constants;
use crate::arithmetic::native::pair::Pair;

pub(crate) const fn constants(c: &Constants<Pair<f64>>) -> Constants<Double> {
    Constants {
        half_pi: Double::from_pair(c.half_pi),
        two_pi: Double::from_pair(c.two_pi),
        pi: Double::from_pair(c.pi),
        recip_pi: Double::from_pair(c.recip_pi),
        two_over_pi: Double::from_pair(c.two_over_pi),
        recip_two_pi: Double::from_pair(c.recip_two_pi),
        twelve_pi: Double::from_pair(c.twelve_pi),
        three_over_two_pi: Double::from_pair(c.three_over_two_pi),
        two_over_three_pi: Double::from_pair(c.two_over_three_pi),
        ln_2: Double::from_pair(c.ln_2),
        ln_two_pi: Double::from_pair(c.ln_two_pi),
        ln_pi: Double::from_pair(c.ln_pi),
        ln_two_over_pi: Double::from_pair(c.ln_two_over_pi),
        ln_three_over_two_pi: Double::from_pair(c.ln_three_over_two_pi),
    }
}
