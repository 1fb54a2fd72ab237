//! The formulas' kernels in double-double.

use crate::arithmetic::constants::Constants;
use crate::arithmetic::double::arith::scaled;
use crate::arithmetic::double::{Double, angle, disk, log_exp, root};
use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::native::f64::power_of_two;
use crate::arithmetic::native::float::Float;
use crate::arithmetic::native::format::Native;
use crate::arithmetic::native::pair::Pair;
use crate::arithmetic::native::turn::into_quadrant;
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

const fn constants(c: &Constants<Pair<f64>>) -> Constants<Double> {
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

/// A power that comes this near to an `f64` is one: c³ of a short c must be met exactly, since it can
/// be a tie of a shorter format.
#[inline]
fn snapped(x: Double) -> Double {
    if x.lo.abs() < x.hi.abs() * power_of_two(-90) {
        Double::exact(x.hi)
    } else {
        x
    }
}

/// 1 − (1 − v)ᵐ for small mv, by the binomial series: beside the axis mv itself can be a tie of a
/// shorter format, and then the sign of what follows decides.
#[inline]
fn one_minus_power(m: Double, v: Double) -> Double {
    let mut rest = Double::ONE;
    for j in (1..7).rev() {
        let step = (m - Double::int(j)) * v / Double::int(j + 1);
        rest = if j == 1 {
            step * rest
        } else {
            Double::ONE - step * rest
        };
    }
    let first = m * v;
    let sum = first - first * rest;
    if sum.lo == 0.0 {
        // Too small to be held; its sign is not.
        let least = sum.hi * power_of_two(-120);
        let lo = if rest.hi > 0.0 {
            -least
        } else if rest.hi < 0.0 {
            least
        } else {
            0.0
        };
        return Double { hi: sum.hi, lo };
    }
    sum
}

impl Kernel for Double {
    type Wide = Double;

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
        // Below this, trailing words would underflow on the way.
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
    fn cbrt_wide(self) -> Self {
        Kernel::cbrt(self)
    }
    /// True: a double-double has nothing more to refine.
    #[inline(always)]
    fn is_negligible(self) -> bool {
        true
    }
    #[inline]
    fn ln(self) -> Self {
        log_exp::ln(self)
    }
    #[inline]
    fn ln_cos(at: CosSin<Self>) -> Self {
        if at.cos < at.sin {
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
    fn at_angle_fine(theta: Self) -> CosSin<Self> {
        angle::at_angle(theta.hi)
    }
    #[inline]
    fn at_quadrant(quadrant: u32, x: Self) -> CosSin<Self> {
        into_quadrant(quadrant, angle::at_eighth(x))
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
    fn ln_cos_power(k: Self, at: CosSin<Self>) -> Self {
        let product = if at.sin.hi < power_of_two(-60) {
            // −k·sin²θ/2, in an order that does not underflow for a k as large as 1/sin²θ.
            -(k * at.sin * at.sin * Self::HALF)
        } else {
            k * Self::ln_cos(at)
        };
        // A pair that is no unit vector: the logarithm is −∞, and k tells the sign.
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
