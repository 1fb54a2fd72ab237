//! The truth, in double-double and from other formulas than the crate's kernels use.
//! Within 3·10⁻²⁴ of mpmath at 65 tails from 10⁻³⁰⁰ to ½ for each shape.
//!
//! p is the tail of the horizon: in the plane that of the nearer end, P(Θ ≤ −|θ|); in space P(Θ > θ).

use crate::double::Double;
use std::f64::consts::FRAC_PI_2;

const PI: Double = Double {
    hi: std::f64::consts::PI,
    lo: 1.2246467991473532e-16,
};
const TWO_OVER_PI: Double = Double {
    hi: std::f64::consts::FRAC_2_PI,
    lo: -3.935735335036497e-17,
};
const LN_2: Double = Double {
    hi: std::f64::consts::LN_2,
    lo: 2.3190468138462996e-17,
};

/// A law's mathematics, with no number type.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Disk,
    CircleShell,
    CircleArc,
    /// In space, density ∝ cosᵏθ per steradian.
    Power(f64),
}

impl Shape {
    /// cdf of θ in double precision: enough for the cells of a histogram.
    pub(crate) fn cdf(self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        match self {
            Shape::Disk => 0.5 + (theta + sin * cos) / PI.hi,
            Shape::CircleShell => (1.0 + sin) / 2.0,
            Shape::CircleArc => 0.5 + theta / PI.hi,
            Shape::Power(k) => -((k + 1.0) * ln_cos(theta)).exp_m1(),
        }
    }

    /// The part of the support that a histogram covers, in radians: beyond a narrow lobe's
    /// millionth there is nothing to see.
    pub(crate) fn window(self) -> (f64, f64) {
        match self {
            Shape::Power(k) => {
                // From sin²θ = 1 − cos²θ, since acos near 1 has few digits.
                let sin_squared = -(2.0 * 1e-6f64.ln() / (k + 1.0)).exp_m1();
                let end = sin_squared.sqrt().asin();
                (0.0, if end > 1.3 { FRAC_PI_2 } else { end })
            }
            _ => (-FRAC_PI_2, FRAC_PI_2),
        }
    }

    /// cos θ at the tail p, to some 24 digits.
    pub(crate) fn cos_at(self, p: f64) -> Double {
        match self {
            Shape::Disk if p < 0.09 => disk_cos(p),
            Shape::Disk => complement(disk_sin(Double::sum(0.5, -p))),
            Shape::CircleShell => {
                let root = sqrt(Double::from(p) * Double::sum(1.0, -p));
                root + root
            }
            Shape::CircleArc if p < 0.25 => sine(PI * Double::from(p)),
            Shape::CircleArc => complement(sine(PI * Double::sum(0.5, -p))),
            Shape::Power(k) => root(p, Double::sum(k, 1.0)),
        }
    }
}

/// ln cos θ with the digits that cos θ near 1 has lost.
fn ln_cos(theta: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    if sin.abs() < 0.7 {
        (-sin * sin).ln_1p() / 2.0
    } else {
        cos.max(0.0).ln()
    }
}

/// Newton's method with quadratic convergence: one step more than double precision shows.
fn newton(start: f64, step: impl Fn(Double) -> Double) -> Double {
    let mut x = Double::from(start);
    for _ in 0..40 {
        let change = step(x);
        x = x - change;
        if change.hi.abs() <= 1e-14 * x.hi.abs() {
            break;
        }
    }
    x
}

/// √x, x > 0.
fn sqrt(x: Double) -> Double {
    newton(x.hi.sqrt(), |s| (s * s - x) / (s + s))
}

/// √(1 − s²): the other one of cosine and sine.
fn complement(s: Double) -> Double {
    sqrt(Double::from(1.0) - s * s)
}

/// Σ termₙ/divisor(n) from the term 1, each term `ratio(n)` times the one before, until it is spent.
fn series(ratio: impl Fn(f64) -> Double, divisor: impl Fn(f64) -> f64) -> Double {
    let mut term = Double::from(1.0);
    let mut sum = term / Double::from(divisor(0.0));
    for n in 1..200 {
        let n = f64::from(n);
        term = term * ratio(n);
        let next = term / Double::from(divisor(n));
        sum = sum + next;
        if next.hi.abs() < 1e-33 * sum.hi.abs() {
            break;
        }
    }
    sum
}

/// Σ aₙ wⁿ/(2n + first), with a₀ = 1 and aₙ = aₙ₋₁ (n − shift)/n.
fn binomial_series(w: Double, shift: f64, first: f64) -> Double {
    let ratio = |n| w * Double::from(n - shift) / Double::from(n);
    series(ratio, |n| 2.0 * n + first)
}

/// cos θ of the disk from p = (2/π) ∫₀ᶜ c²/√(1 − c²) dc, termwise: no cancellation.
fn disk_cos(p: f64) -> Double {
    newton((1.5 * PI.hi * p).cbrt(), |c| {
        let w = c * c;
        let tail = TWO_OVER_PI * c * w * binomial_series(w, 0.5, 3.0);
        (tail - Double::from(p)) * complement(c) / (TWO_OVER_PI * w)
    })
}

/// sin θ of the disk from d = ½ − p = (2/π) ∫₀ˢ √(1 − s²) ds, termwise.
fn disk_sin(d: Double) -> Double {
    if d.hi == 0.0 {
        return d;
    }
    newton(FRAC_PI_2 * d.hi, |s| {
        let middle = TWO_OVER_PI * s * binomial_series(s * s, 1.5, 1.0);
        (middle - d) / (TWO_OVER_PI * complement(s))
    })
}

/// sin x by Taylor's series, 0 ≤ x ≤ π/4.
fn sine(x: Double) -> Double {
    let w = -(x * x);
    x * series(|n| w / Double::from(2.0 * n * (2.0 * n + 1.0)), |_| 1.0)
}

/// eᵃ for |a| < 700.
fn exp(a: Double) -> Double {
    let n = (a.hi / LN_2.hi).round();
    let r = a - LN_2 * Double::from(n);
    series(|i| r / Double::from(i), |_| 1.0).scale(n as i32)
}

/// ln p, by Newton's method on the exponential.
fn ln(p: f64) -> Double {
    newton(p.ln(), |y| Double::from(1.0) - exp(-y) * Double::from(p))
}

/// p^(1/n): by Newton on repeated multiplication where n is a small whole number.
fn root(p: f64, n: Double) -> Double {
    let whole = n.hi;
    if n.lo == 0.0 && whole.fract() == 0.0 && whole <= 64.0 {
        newton(p.powf(1.0 / whole), |c| {
            let power = (1..whole as u32).fold(Double::from(1.0), |power, _| power * c);
            (c * power - Double::from(p)) / (power * n)
        })
    } else {
        exp(ln(p) / n)
    }
}
