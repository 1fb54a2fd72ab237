//! The formulas' kernels in double-double.

use crate::arithmetic::constants::Constants;
use crate::arithmetic::double::arith::scaled;
use crate::arithmetic::double::constants::constants;
use crate::arithmetic::double::power::{one_minus_power, snapped};
use crate::arithmetic::double::{Double, angle, disk, log_exp, root};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::logarithmic::{self, Logarithmic};
use crate::arithmetic::native::f64::power_of_two;
use crate::arithmetic::native::float::Float;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::turn::into_quadrant;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

impl Double {
    /// (cos, sin) at `quadrant`/4 + x turns, |x| ≤ 1/8.
    #[inline]
    pub(crate) fn at_quadrant(quadrant: u32, x: Self) -> CosSin<Self> {
        into_quadrant(quadrant, angle::at_eighth(x))
    }
}

impl Kernel for Double {
    type Wide = Double;
    type Cosine = CosSin<Self>;
    type Scale = Self;
    type TailRoot = Self;

    const CONSTANTS: Constants<Double> = constants(&<f64 as Native>::CONSTANTS);

    #[inline]
    fn sqrt_scaled(a: Self, f: impl Fn(Self) -> Self) -> Self {
        scaled(
            root::sqrt(f(scaled(a, power_of_two(200)))),
            power_of_two(-100),
        )
    }
    #[inline]
    fn cbrt(self) -> Self {
        // Below this, trailing parts would underflow on the way.
        if self.hi < power_of_two(-500) {
            scaled(
                root::cbrt(scaled(self, power_of_two(900))),
                power_of_two(-300),
            )
        } else {
            root::cbrt(self)
        }
    }
    #[inline]
    fn ln(self) -> Self {
        log_exp::ln(self)
    }
    #[inline]
    fn ln_cos(at: CosSin<Self>) -> Self {
        if at.cos <= at.sin {
            log_exp::ln(at.cos)
        } else {
            log_exp::ln_1p(-(at.sin * at.sin)) * Self::HALF
        }
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        angle::atan2(self, x)
    }
    #[inline]
    fn from_end(a: Self) -> Self {
        angle::from_end(a.hi)
    }
    #[inline]
    fn at_angle(theta: Self) -> CosSin<Self> {
        angle::at_angle(theta.hi)
    }
    #[inline]
    fn at_turn(u: Self) -> CosSin<Self> {
        let quadrant = (u.hi * 4.0 + 0.5) as u32;
        Self::at_quadrant(quadrant, u - Self::from_number(0.25 * f64::from(quadrant)))
    }
    #[inline]
    fn half_turn(p: Self) -> CosSin<Self> {
        if p < Self::QUARTER {
            angle::swapped(angle::sin_cos(p * Self::CONSTANTS.pi))
        } else {
            angle::sin_cos((Self::HALF - p) * Self::CONSTANTS.pi)
        }
    }
    #[inline]
    fn disk_tail_at_angle(a: Self) -> Self {
        disk::tail_at_angle(a.hi)
    }
    #[inline]
    fn disk_tail_at_direction(cos: Self, sin: Self) -> Self {
        disk::tail_at_direction(cos, sin)
    }
    #[inline]
    fn disk_direction_at_tail(p: Self) -> CosSin<Self> {
        disk::direction_at_tail(p)
    }
    #[inline]
    fn disk_angle_at_tail(p: Self) -> Self {
        let (x, from_end) = disk::angle_at_tail(p);
        if from_end { angle::pair_from_end(x) } else { x }
    }
    #[inline]
    fn ln_wide(x: Self) -> Self {
        log_exp::ln(x)
    }
    #[inline]
    fn cosine(at: CosSin<Self>) -> CosSin<Self> {
        at
    }
    #[inline]
    fn cosine_at_angle(theta: Self) -> (CosSin<Self>, Self) {
        let at = Self::at_angle(theta);
        (at, at.sin)
    }
    #[inline]
    fn scale(x: Self) -> Self {
        x
    }
    #[inline]
    fn two_over(x: Self) -> Self {
        Self::int(2) / x
    }
    #[inline]
    fn power_times(k: Self, at: CosSin<Self>, scale: Self, factor: Self) -> Self {
        logarithmic::power_times(k, at, scale * factor)
    }
    #[inline]
    fn ln_power_times_sine(k: Self, at: CosSin<Self>, c: Self) -> Self {
        logarithmic::ln_power_times_sine(k, at, c)
    }
    #[inline]
    fn tail_root(n: Self) -> Self {
        n
    }
    #[inline]
    fn power_tails(n: Self, at: CosSin<Self>) -> (Self, Self) {
        let square = at.sin * at.sin;
        let a = Self::ln_cos_power(n, at);
        // Not where the square has lost digits to underflow.
        let held = square.hi > power_of_two(-700);
        let lower = if held && n.hi * square.hi < power_of_two(-20) {
            one_minus_power(n * Self::HALF, square)
        } else {
            Self::one_minus_exp(a)
        };
        (lower, Self::exp_times(a, Self::ONE))
    }
    #[inline]
    fn power_warp(p: Tails<Self>, n: Self) -> CosSin<Self> {
        let (lower, upper) = (p.lower(), p.upper());
        if upper == Self::ZERO {
            return CosSin {
                cos: Self::ZERO,
                sin: Self::ONE,
            };
        }
        let log = if upper < Self::HALF {
            log_exp::ln(upper)
        } else {
            log_exp::ln_1p(-lower)
        };
        let a = log / n;
        let sin = if -a.hi < power_of_two(-200) {
            // sin²θ = −2a, which for large n underflows before its root does.
            Self::sqrt_scaled(-(log + log), |x| x) / root::sqrt(n)
        } else {
            root::sqrt(Self::one_minus_exp(a + a))
        };
        CosSin {
            cos: Self::exp_times(a, Self::ONE),
            sin,
        }
    }
}

impl Logarithmic for Double {
    #[inline]
    fn ln_cos_power(k: Self, at: CosSin<Self>) -> Self {
        let product = if at.sin.hi < power_of_two(-60) {
            // −k·sin²θ/2, in an order that does not underflow for a k as large as 1/sin²θ.
            -(k * at.sin * at.sin * Self::HALF)
        } else {
            k * Self::ln_cos(at)
        };
        // At what is no unit vector the logarithm is −∞, and k tells the sign.
        if product.is_finite() {
            product
        } else if k > Self::ZERO {
            -Self::INFINITY
        } else {
            Self::INFINITY
        }
    }
    #[inline]
    fn exp_times(a: Self, c: Self) -> Self {
        let (m, n) = log_exp::exp(a);
        let product = c * snapped(m);
        Double {
            hi: product.hi.scale(n),
            lo: product.lo.scale(n),
        }
    }
    #[inline]
    fn one_minus_exp(a: Self) -> Self {
        snapped(-log_exp::exp_m1(a))
    }
}
