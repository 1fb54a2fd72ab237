//! The kernels of [`Scaled`]: those of double-double where its exponents reach, else the leading
//! term of the series, which there has all digits.

use super::{DIGITS, Scaled};
use crate::arithmetic::constants::Constants;
use crate::arithmetic::double::{Double, angle, disk, log_exp, root};
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::logarithmic::{self, Logarithmic};
use crate::arithmetic::native::turn::into_quadrant;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

/// Angles below 2 to the minus this have the cosine 1, and themselves as sine, to all digits.
const HALF_DIGITS: i32 = DIGITS / 2;

const fn constants(c: &Constants<Double>) -> Constants<Scaled> {
    Constants {
        half_pi: Scaled::new(c.half_pi, 0),
        two_pi: Scaled::new(c.two_pi, 0),
        pi: Scaled::new(c.pi, 0),
        recip_pi: Scaled::new(c.recip_pi, 0),
        two_over_pi: Scaled::new(c.two_over_pi, 0),
        recip_two_pi: Scaled::new(c.recip_two_pi, 0),
        twelve_pi: Scaled::new(c.twelve_pi, 0),
        three_over_two_pi: Scaled::new(c.three_over_two_pi, 0),
        two_over_three_pi: Scaled::new(c.two_over_three_pi, 0),
        ln_2: Scaled::new(c.ln_2, 0),
        ln_two_pi: Scaled::new(c.ln_two_pi, 0),
        ln_pi: Scaled::new(c.ln_pi, 0),
        ln_two_over_pi: Scaled::new(c.ln_two_over_pi, 0),
        ln_three_over_two_pi: Scaled::new(c.ln_three_over_two_pi, 0),
    }
}

fn pair(at: CosSin<Double>) -> CosSin<Scaled> {
    CosSin::from_array(at.to_array().map(Scaled::from_double))
}

/// The angle of (x, y), neither of them 0, ∞ or NaN, and so far apart that atan r = r.
fn atan2_far_apart(y: Scaled, x: Scaled) -> Scaled {
    let c = &Scaled::CONSTANTS;
    let angle = if y.exponent > x.exponent {
        // x/|y| has the sign of x.
        c.half_pi - x / y.abs()
    } else if x < Scaled::ZERO {
        c.pi - (y / x).abs()
    } else {
        (y / x).abs()
    };
    angle.copysign(y)
}

/// η with 2η³/3π = p, the disk's tail for a small angle η from its end.
fn disk_end(p: Scaled) -> Scaled {
    Kernel::cbrt(p * Scaled::CONSTANTS.twelve_pi) * Scaled::HALF
}

impl Scaled {
    /// (cos, sin) at `quadrant`/4 + x turns, |x| ≤ 1/8.
    pub(crate) fn at_quadrant(quadrant: u32, x: Self) -> CosSin<Self> {
        let at = if x.is_below(-HALF_DIGITS) {
            CosSin {
                cos: Self::ONE,
                sin: x * Self::CONSTANTS.two_pi,
            }
        } else {
            pair(angle::at_eighth(x.double()))
        };
        into_quadrant(quadrant, at)
    }
}

impl Kernel for Scaled {
    type Wide = Scaled;
    type Cosine = CosSin<Self>;
    type Scale = Self;
    type TailRoot = Self;

    const CONSTANTS: Constants<Scaled> = constants(&Double::CONSTANTS);

    fn sqrt_scaled(a: Self, f: impl Fn(Self) -> Self) -> Self {
        f(a).sqrt()
    }
    fn cbrt(self) -> Self {
        let (part, e) = self.split_by(3);
        Self::new(root::cbrt(part), e)
    }
    fn ln(self) -> Self {
        if self.exponent.wrapping_abs() <= DIGITS {
            return Self::from_double(log_exp::ln(self.double()));
        }
        let e = Double::from_f64(f64::from(self.exponent));
        Self::from_double(Double::CONSTANTS.ln_2 * e + log_exp::ln(self.part))
    }
    fn ln_cos(at: CosSin<Self>) -> Self {
        if at.cos <= at.sin {
            Kernel::ln(at.cos)
        } else if at.sin.is_below(-HALF_DIGITS) {
            -(at.sin * at.sin) * Self::HALF
        } else {
            Self::from_double(log_exp::ln_1p((-(at.sin * at.sin)).double())) * Self::HALF
        }
    }
    fn atan2(self, x: Self) -> Self {
        let apart = self.exponent.wrapping_sub(x.exponent);
        if !(self.is_ordinary() && x.is_ordinary()) {
            // The sizes do not count beside 0 and ∞.
            Self::from_double(angle::atan2(self.part, x.part))
        } else if apart.wrapping_abs() > DIGITS {
            atan2_far_apart(self, x)
        } else {
            let [y, x] = [self, x].map(|c| c.times_power(x.exponent.wrapping_neg()).double());
            Self::from_double(angle::atan2(y, x))
        }
    }
    fn from_end(a: Self) -> Self {
        Self::from_double(angle::from_end(a.double().hi))
    }
    fn at_angle(theta: Self) -> CosSin<Self> {
        if theta.is_below(-HALF_DIGITS) {
            return CosSin {
                cos: Self::ONE,
                sin: theta.abs(),
            };
        }
        pair(angle::at_angle(theta.double().hi))
    }
    fn at_turn(u: Self) -> CosSin<Self> {
        let quadrant = (u.double().hi * 4.0 + 0.5) as u32;
        Self::at_quadrant(quadrant, u - Self::int(quadrant as i16) * Self::QUARTER)
    }
    fn half_turn(p: Self) -> CosSin<Self> {
        if p.is_below(-HALF_DIGITS) {
            CosSin {
                cos: p * Self::CONSTANTS.pi,
                sin: Self::ONE,
            }
        } else {
            pair(Double::half_turn(p.double()))
        }
    }
    fn disk_tail_at_angle(a: Self) -> Self {
        Self::from_double(disk::tail_at_angle(a.double().hi))
    }
    fn disk_tail_at_direction(cos: Self, sin: Self) -> Self {
        if cos.is_below(-HALF_DIGITS) {
            cos * cos * cos * Self::CONSTANTS.two_over_three_pi
        } else {
            Self::from_double(disk::tail_at_direction(cos.double(), sin.double()))
        }
    }
    fn disk_direction_at_tail(p: Self) -> CosSin<Self> {
        if p.is_below(-2 * DIGITS) {
            return CosSin {
                cos: disk_end(p),
                sin: Self::ONE,
            };
        }
        pair(disk::direction_at_tail(p.double()))
    }
    fn disk_angle_at_tail(p: Self) -> Self {
        if p.is_below(-2 * DIGITS) {
            return Self::CONSTANTS.half_pi - disk_end(p);
        }
        Self::from_double(Double::disk_angle_at_tail(p.double()))
    }
    fn ln_wide(x: Self) -> Self {
        Kernel::ln(x)
    }
    fn cosine(at: CosSin<Self>) -> CosSin<Self> {
        at
    }
    fn cosine_at_angle(theta: Self) -> (CosSin<Self>, Self) {
        let at = Self::at_angle(theta);
        (at, at.sin)
    }
    fn scale(x: Self) -> Self {
        x
    }
    fn two_over(x: Self) -> Self {
        Self::int(2) / x
    }
    fn power_times(k: Self, at: CosSin<Self>, scale: Self, factor: Self) -> Self {
        logarithmic::power_times(k, at, scale * factor)
    }
    fn ln_power_times_sine(k: Self, at: CosSin<Self>, c: Self) -> Self {
        logarithmic::ln_power_times_sine(k, at, c)
    }
    fn power_tails(n: Self, at: CosSin<Self>) -> (Self, Self) {
        logarithmic::power_tails(n, at)
    }
    fn tail_root(n: Self) -> Self {
        n
    }
    fn power_warp(p: Tails<Self>, n: Self) -> CosSin<Self> {
        let (lower, upper) = (p.lower(), p.upper());
        if upper == Self::ZERO {
            return CosSin {
                cos: Self::ZERO,
                sin: Self::ONE,
            };
        }
        let log = if upper < Self::HALF {
            Kernel::ln(upper)
        } else if lower.is_below(-DIGITS) {
            -lower
        } else {
            Self::from_double(log_exp::ln_1p(-lower.double()))
        };
        let a = log / n;
        CosSin {
            cos: Self::exp_times(a, Self::ONE),
            sin: Self::one_minus_exp(a + a).sqrt(),
        }
    }
}

impl Logarithmic for Scaled {
    fn ln_cos_power(k: Self, at: CosSin<Self>) -> Self {
        let product = k * Self::ln_cos(at);
        // At what is no unit vector the logarithm is −∞, and k tells the sign.
        if product.is_finite() {
            product
        } else if k > Self::ZERO {
            -Self::INFINITY
        } else {
            Self::INFINITY
        }
    }
    fn exp_times(a: Self, c: Self) -> Self {
        if a.is_below(-DIGITS) {
            return c;
        }
        let (part, n) = log_exp::exp(a.double());
        c * Self::new(part, n)
    }
    fn one_minus_exp(a: Self) -> Self {
        if a.is_below(-DIGITS) {
            return -a;
        }
        // Of an exact 0, the positive one.
        Self::from_double(log_exp::exp_m1(a.double())).abs()
    }
}
