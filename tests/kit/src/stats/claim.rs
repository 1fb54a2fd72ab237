//! What each law claims, in `f64` closed forms that share nothing with the crate.

use crate::{Id, Number};
use coslobe::{Law, Moments};
use std::f64::consts::{PI, TAU};

/// A direction as \[x, y, z\], y along the axis; z = 0 in the plane.
pub type Direction = [f64; 3];

/// A law p ∝ cosᵏθ with its moments as the crate has them.
#[derive(Clone)]
pub struct Claim {
    pub name: String,
    pub planar: bool,
    pub k: f64,
    pub moments: Moments<f64>,
    /// Precision of the number type.
    pub epsilon: f64,
    /// [`Number::LENGTH`], [`Number::ERROR`] and [`Number::GRID`].
    pub length: f64,
    pub error: f64,
    pub grid: f64,
}

impl Claim {
    /// What `law` claims, which is `id`'s.
    pub fn of<T: Number>(id: Id, law: &impl Law<T>) -> Self {
        let k = T::of(id.exponent()).into();
        Self::new(&id.to_string(), id.planar(), k, law.moments())
    }

    pub fn new<T: Number>(name: &str, planar: bool, k: f64, m: Moments<T>) -> Self {
        Claim {
            name: format!("{name} {}", T::NAME),
            planar,
            k,
            moments: Moments {
                mean_cos: m.mean_cos.into(),
                var_cos: m.var_cos.into(),
                mean_theta: m.mean_theta.into(),
                var_theta: m.var_theta.into(),
                entropy: m.entropy.into(),
            },
            epsilon: T::EPSILON,
            length: T::LENGTH,
            error: T::ERROR,
            grid: T::GRID,
        }
    }

    /// Relative error of the nearer tail, and of −k ln cos θ + 1, for that of the smaller
    /// component.
    pub fn slack(&self, cos: f64, sin: f64) -> f64 {
        let tangent = sin / cos;
        self.error * (2.0f64).max((self.k + 1.0) * (tangent * tangent).min(1.0))
    }

    /// (smaller of cdf and sf of θ, whether it is the sf), from the smaller of cos θ and |sin θ|.
    pub fn tail(&self, cos: f64, sin: f64) -> (f64, bool) {
        if self.planar {
            (self.planar_tail(cos, sin.abs()), sin > 0.0)
        } else {
            let power = (self.k + 1.0) * ln_cos(cos, sin);
            let (lower, upper) = (-power.exp_m1(), power.exp());
            (lower.min(upper), upper < lower)
        }
    }

    fn planar_tail(&self, cos: f64, sin: f64) -> f64 {
        let from_end = cos.atan2(sin);
        match self.k {
            0.0 => from_end / PI,
            1.0 => cos * cos / (2.0 * (1.0 + sin)),
            2.0 => minus_sine(2.0 * from_end) / TAU,
            k => panic!("no closed form for k = {k} in the plane"),
        }
    }

    /// −ln p of a direction, per radian or per steradian.
    pub fn surprise(&self, cos: f64, sin: f64) -> f64 {
        let scale = match (self.planar, self.k) {
            (false, k) => (k + 1.0) / TAU,
            (true, 0.0) => 1.0 / PI,
            (true, 1.0) => 0.5,
            (true, _) => 2.0 / PI,
        };
        -scale.ln() - self.k * ln_cos(cos, sin)
    }
}

fn ln_cos(cos: f64, sin: f64) -> f64 {
    if cos < sin.abs() {
        cos.ln()
    } else {
        0.5 * (-sin * sin).ln_1p()
    }
}

/// y − sin y; by its series where the difference would lose digits.
fn minus_sine(y: f64) -> f64 {
    if y > 0.5 {
        return y - y.sin();
    }
    let mut term = y * y * y / 6.0;
    let mut sum = 0.0;
    for n in 2..10 {
        sum += term;
        term *= -y * y / f64::from((2 * n) * (2 * n + 1));
    }
    sum
}
