//! The laws by name, and all that their formulas read about a direction.

pub use super::formula::*;
use super::wide::Wide;

pub use crate::Id;

/// Everything about a direction that the formulas read, for θ in [0, π/2].
#[derive(Clone, Copy, Default)]
pub struct Direction<W> {
    pub theta: W,
    /// π/2 − θ.
    pub eta: W,
    pub cos: W,
    pub sin: W,
    /// ln cos θ and ln sin θ, where they were asked for beforehand.
    logs: Option<(W, W)>,
}

impl<W: Wide> Direction<W> {
    pub fn at_angle(theta: f64) -> Self {
        let (theta_w, eta) = (W::of(theta), W::from_end(theta));
        let (cos, sin) = if theta < 0.8 {
            let (s, c) = theta_w.sin_cos();
            (c, s)
        } else {
            eta.sin_cos()
        };
        Self::new(theta_w, eta, cos, sin)
    }

    /// From the smaller of the two components.
    pub fn at_pair(cos: f64, sin: f64) -> Self {
        let one = W::of(1.0);
        if cos <= sin {
            let cos = W::of(cos);
            let sin = (one - cos * cos).root();
            let eta = W::angle(sin, cos);
            Self::new(W::pi() * W::of(0.5) - eta, eta, cos, sin)
        } else {
            let sin = W::of(sin);
            let cos = (one - sin * sin).root();
            let theta = W::angle(cos, sin);
            Self::new(theta, W::pi() * W::of(0.5) - theta, cos, sin)
        }
    }

    /// What formulas of the cosine alone read, and cos/cosᵏ.
    pub fn at_cos(cos: f64) -> Self {
        Direction {
            cos: W::of(cos),
            ..Default::default()
        }
    }

    fn new(theta: W, eta: W, cos: W, sin: W) -> Self {
        Direction {
            theta,
            eta,
            cos,
            sin,
            logs: None,
        }
    }

    /// Computes the logarithms once for all laws.
    pub fn with_logs(self) -> Self {
        Direction {
            logs: Some((self.ln_cos(), self.ln_sin())),
            ..self
        }
    }

    pub fn ln_cos(&self) -> W {
        match self.logs {
            Some((ln_cos, _)) => ln_cos,
            None if self.cos < self.sin => self.cos.ln(),
            None => (self.sin * self.sin).ln_one_minus() * W::of(0.5),
        }
    }

    pub fn ln_sin(&self) -> W {
        match self.logs {
            Some((_, ln_sin)) => ln_sin,
            None if self.sin.near() == 0.0 && self.sin <= W::default() => W::of(f64::NEG_INFINITY),
            None => self.sin.ln(),
        }
    }
}
