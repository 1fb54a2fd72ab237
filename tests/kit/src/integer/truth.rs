//! The laws in closed `f64` forms that share nothing with the crate.

use crate::Id;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A law of the family cosᵏ.
#[derive(Clone, Copy)]
pub struct Truth {
    pub name: &'static str,
    pub planar: bool,
    pub k: i32,
}

impl Truth {
    pub fn of(id: Id) -> Self {
        Truth {
            name: id.name(),
            planar: id.planar(),
            k: id.exponent() as i32,
        }
    }
}

/// y with y − sin y = x, by bisection's sure relative: Newton from the series.
fn kepler(x: f64) -> f64 {
    let s = (6.0 * x).cbrt();
    let mut y = s * (1.0 + s * s / 60.0 * (1.0 + s * s * 3.0 / 70.0));
    for _ in 0..4 {
        let square = y * y;
        let (value, slope) = if y < 0.5 {
            let tail = 1.0 - square / 42.0 * (1.0 - square / 72.0 * (1.0 - square / 110.0));
            (
                y * square / 6.0 * (1.0 - square / 20.0 * tail),
                2.0 * (y / 2.0).sin().powi(2),
            )
        } else {
            (y - y.sin(), 1.0 - y.cos())
        };
        if slope > 0.0 {
            y -= (value - x) / slope;
        }
    }
    y
}

/// (cos θ, sin θ) of the law ∝ cosᵏ in space at the tails.
pub fn power_pair(k: f64, lower: f64, upper: f64) -> (f64, f64) {
    let n = k + 1.0;
    // sin² = 1 − (1 − u)^(2/n) without a difference.
    let square = -(2.0 / n * (-lower).ln_1p()).exp_m1();
    (upper.powf(1.0 / n), square.sqrt())
}

impl Truth {
    /// (cos θ, sin θ) at the tails.
    pub fn pair(&self, lower: f64, upper: f64) -> (f64, f64) {
        if !self.planar {
            return power_pair(f64::from(self.k), lower, upper);
        }
        let (p, sign) = if lower < upper {
            (lower, -1.0)
        } else {
            (upper, 1.0)
        };
        match self.k {
            0 => ((PI * p).sin(), sign * (PI * p).cos()),
            1 => (2.0 * (p * (1.0 - p)).sqrt(), sign * (1.0 - 2.0 * p)),
            _ => {
                let eta = kepler(TAU * p) / 2.0;
                (eta.sin(), sign * eta.cos())
            }
        }
    }

    /// [cdf, sf] at θ in turns.
    pub fn tails(&self, turn: f64) -> [f64; 2] {
        let (sin, cos) = (turn * TAU).sin_cos();
        if !self.planar {
            let upper = if turn < 0.0 {
                1.0
            } else if turn >= 0.25 {
                0.0
            } else {
                cos.powi(self.k + 1)
            };
            return [1.0 - upper, upper];
        }
        let upper = if turn >= 0.25 {
            0.0
        } else if turn <= -0.25 {
            1.0
        } else {
            match self.k {
                0 => 0.5 - 2.0 * turn,
                1 => (1.0 - sin) / 2.0,
                _ => 0.5 - 2.0 * turn - sin * cos / PI,
            }
        };
        [1.0 - upper, upper]
    }

    /// Density at cos θ > 0.
    pub fn density_at(&self, cos: f64) -> f64 {
        let scale = match (self.planar, self.k) {
            (true, 0) => 1.0 / PI,
            (true, 1) => 0.5,
            (true, _) => 2.0 / PI,
            (false, k) => f64::from(k + 1) / TAU,
        };
        scale * cos.powi(self.k)
    }

    /// cos θ / π, in the plane cos θ / 2, over the density.
    pub fn weight_at(&self, cos: f64) -> f64 {
        let white = if self.planar { 0.5 } else { 1.0 / PI };
        white / self.density_at(1.0) * cos.powi(1 - self.k)
    }

    /// 2ρ cos θ times what of its ray a uniform v chooses.
    pub fn distance(&self, rho: f64, cos: f64, v: f64) -> f64 {
        let share = match self.name {
            "Disk" => v.sqrt(),
            "Ball" => v.cbrt(),
            _ => 1.0,
        };
        2.0 * rho * cos * share
    }

    pub fn pdf_at(&self, turn: f64) -> f64 {
        let theta = turn * TAU;
        let inside = turn <= 0.25 && turn >= if self.planar { -0.25 } else { 0.0 };
        let density = self.density_at(theta.cos().max(0.0));
        match (inside, self.planar) {
            (false, _) => 0.0,
            (true, true) => density,
            (true, false) => density * theta.sin(),
        }
    }

    /// θ in turns at the tails.
    pub fn turn(&self, lower: f64, upper: f64) -> f64 {
        let (cos, sin) = self.pair(lower, upper);
        (sin.atan2(cos)).clamp(-FRAC_PI_2, FRAC_PI_2) / TAU
    }
}
