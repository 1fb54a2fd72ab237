//! z-test of a mean whose exact value is known.

use statrs::function::erf::erfc;

/// Accumulates f(x) − E\[f(x)\].
pub struct Mean {
    expected: f64,
    /// Sum of what the errors of the single values allow.
    tolerance: f64,
    n: f64,
    sum: f64,
    squares: f64,
}

impl Mean {
    pub fn of(expected: f64) -> Self {
        Mean {
            expected,
            tolerance: 0.0,
            n: 0.0,
            sum: 0.0,
            squares: 0.0,
        }
    }

    /// `slack`: the error that `x` may have, and the expected value.
    pub fn add(&mut self, x: f64, slack: f64) {
        let d = x - self.expected;
        self.n += 1.0;
        self.tolerance += slack;
        self.sum += d;
        self.squares += d * d;
    }

    pub fn p_value(&self) -> f64 {
        let mean = self.sum / self.n;
        let variance = (self.squares / self.n - mean * mean).max(0.0);
        let error = (variance / self.n).sqrt() + self.tolerance / self.n;
        if mean == 0.0 {
            return 1.0;
        }
        erfc((mean / error).abs() / std::f64::consts::SQRT_2)
    }
}
