//! Double-double as the wider arithmetic.

use super::double::Double;
use super::wide::{HALF_PI, Wide, alternating, kepler_tail};
use std::sync::LazyLock;

static INVERSE_FACTORIALS: LazyLock<[Double; 48]> = LazyLock::new(|| {
    let mut all = [two(1.0); 48];
    for n in 1..all.len() {
        all[n] = all[n - 1] / two(n as f64);
    }
    all
});

fn two(x: f64) -> Double {
    Double::from(x)
}

/// eʳ − 1 for |r| ≤ 1/2: the series at r/8, then three times e²ˣ − 1 = (eˣ − 1)(eˣ + 1).
pub fn small_exp_m1(r: Double) -> Double {
    let (halvings, terms) = if r.hi.abs() < 1e-6 { (0, 6) } else { (3, 16) };
    let x = r.scale(-halvings);
    let sum = (1..terms)
        .rev()
        .fold(two(0.0), |sum, n| sum * x + Double::inverse_factorial(n));
    (0..halvings).fold(sum * x, |power, _| power * (power + two(2.0)))
}

/// (n, eʳ) with x = n ln 2 + r.
pub fn exp_parts(x: Double) -> (f64, Double) {
    let n = (x.hi / LN_2[0]).round();
    let r = x - Double::product(n, LN_2[0]) - Double::product(n, LN_2[1]);
    (n, two(1.0) + small_exp_m1(r))
}

/// ln m for m about 1: Newton's step on the exponential.
pub fn ln_near_one(m: Double) -> Double {
    let guess = two(m.hi.ln());
    guess + (m / (two(1.0) + small_exp_m1(guess)) - two(1.0))
}

pub const LN_2: [f64; 2] = [std::f64::consts::LN_2, 2.3190468138462996e-17];

impl Wide for Double {
    const EPS: f64 = 1e-28;
    const TERMS: usize = 17;
    const KEPLER_TERMS: usize = 14;
    fn of(x: f64) -> Self {
        two(x)
    }
    fn parts(hi: f64, lo: f64) -> Self {
        Double::sum(hi, lo)
    }
    fn near(self) -> f64 {
        self.hi
    }
    fn minus(self, x: f64) -> f64 {
        (self.hi - x) + self.lo
    }
    fn root(self) -> Self {
        if self.hi <= 0.0 {
            return two(0.0);
        }
        // Scaled by an even power where residuals could underflow.
        if !(1e-200..1e200).contains(&self.hi) {
            let n = (self.hi.log2() / 2.0) as i32;
            return self.scale(-2 * n).root().scale(n);
        }
        let guess = self.hi.sqrt();
        let rest = (self - Double::product(guess, guess)).hi / (guess * 2.0);
        // A second step, since the first leaves the square of half a last place.
        let root = Double::sum(guess, rest);
        let rest = (self - root * root).hi / (guess * 2.0);
        root + two(rest)
    }
    fn cube_root(self) -> Self {
        if self.hi <= 0.0 {
            return two(0.0);
        }
        let n = (self.hi.log2() / 3.0) as i32;
        let x = self.scale(-3 * n);
        let guess = two(x.hi.cbrt());
        let slope = guess.hi * guess.hi * 3.0;
        let root = guess + two((x - guess * guess * guess).hi / slope);
        (root + two((x - root * root * root).hi / slope)).scale(n)
    }
    fn exp(self) -> Self {
        let (n, power) = exp_parts(self);
        if n < -2500.0 {
            return two(0.0);
        }
        power.scale(n as i32)
    }
    fn ln(self) -> Self {
        if self.hi <= 0.0 {
            return two(f64::NEG_INFINITY);
        }
        let n = self.hi.log2().round() as i32;
        let m = self.scale(-n);
        let n = f64::from(n);
        ln_near_one(m) + Double::product(n, LN_2[0]) + Double::product(n, LN_2[1])
    }
    fn ln_one_minus(self) -> Self {
        if self.hi < 1e-40 {
            return -self;
        }
        if self.hi > 0.25 {
            return Wide::ln(two(1.0) - self);
        }
        // As above, with 1 − x and the power both less 1, so that small x keep their digits.
        let guess = two((-self.hi).ln_1p());
        let power = small_exp_m1(guess);
        guess + (-self - power) / (two(1.0) + power)
    }
    fn one_minus_exp_neg(self) -> Self {
        if self.hi > 0.5 {
            return two(1.0) - Wide::exp(-self);
        }
        if self.hi < 1e-40 {
            return self;
        }
        -small_exp_m1(-self)
    }
    fn sin_cos(self) -> (Self, Self) {
        if self.hi > 0.9 {
            let (s, c) = (Self::parts(HALF_PI[0], HALF_PI[1]) - self).sin_cos();
            return (c, s);
        }
        let t = self * self;
        let terms = if self.hi < 1e-3 { 6 } else { Self::TERMS };
        let sin = self * alternating(t, 1, terms);
        // At most 0.9, so that nothing cancels.
        (sin, (two(1.0) - sin * sin).root())
    }
    fn from_end(a: f64) -> Self {
        let d = Double::sum(HALF_PI[0], -a);
        d + Double::sum(HALF_PI[1], HALF_PI[2])
    }
    fn inverse_factorial(n: usize) -> Self {
        INVERSE_FACTORIALS[n]
    }
    fn kepler(p: f64) -> Self {
        // Below 1e-60 the cube root alone is exact, and residuals would underflow.
        if p < 1e-60 {
            let s = (Self::pi() * two(12.0)).cube_root() * two(p).cube_root();
            return s * two(0.5);
        }
        let start = two(f64::kepler(p));
        let (sin, cos) = start.sin_cos();
        let excess = kepler_tail(start, sin, cos) - two(p);
        start - excess * Self::pi() / (sin * sin * two(2.0))
    }
    fn lifted(self, n: i32) -> Double {
        self.scale(n)
    }
}
