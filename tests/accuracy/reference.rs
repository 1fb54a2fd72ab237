//! The laws' true values at a direction, written from the formulas in wider arithmetic.

use super::wide::{Wide, kepler_tail};

/// A law by name; the tests walk this list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Id {
    Disk,
    CircleShell,
    CircleArc,
    Ball,
    SphereShell,
    Lambert,
    CosPower(f64),
}

impl Id {
    pub const FIXED: [Id; 6] = [
        Id::Disk,
        Id::CircleShell,
        Id::CircleArc,
        Id::Ball,
        Id::SphereShell,
        Id::Lambert,
    ];

    /// The name in the table of bounds.
    pub fn name(self) -> &'static str {
        match self {
            Id::Disk => "Disk",
            Id::CircleShell => "CircleShell",
            Id::CircleArc => "CircleArc",
            Id::Ball => "Ball",
            Id::SphereShell => "SphereShell",
            Id::Lambert => "Lambert",
            Id::CosPower(_) => "CosPower",
        }
    }

    pub fn planar(self) -> bool {
        matches!(self, Id::Disk | Id::CircleShell | Id::CircleArc)
    }

    pub fn exponent(self) -> f64 {
        match self {
            Id::CircleArc => 0.0,
            Id::CircleShell | Id::Lambert => 1.0,
            Id::Disk | Id::SphereShell => 2.0,
            Id::Ball => 3.0,
            Id::CosPower(k) => k,
        }
    }
}

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

/// A law's formulas with its constants.
#[derive(Clone, Copy)]
pub struct Formula<W> {
    pub law: Id,
    /// Normalisation of the density per radian or steradian, and its logarithm.
    scale: W,
    ln_scale: W,
    /// Lambert's reflected density over cos θ, over `scale`.
    weight: W,
    k: W,
    recip_pi: W,
}

impl<W: Wide> Formula<W> {
    pub fn new(law: Id) -> Self {
        let (one, two, recip_pi) = (W::of(1.0), W::of(2.0), W::of(1.0) / W::pi());
        let k = W::of(law.exponent());
        let scale = match law {
            Id::Disk => two * recip_pi,
            Id::CircleShell => W::of(0.5),
            Id::CircleArc => recip_pi,
            _ => (k + one) / (W::pi() * two),
        };
        let weight = match law {
            Id::Disk => W::pi() * W::of(0.25),
            Id::CircleShell => one,
            Id::CircleArc => W::pi() * W::of(0.5),
            _ => two / (k + one),
        };
        Formula {
            law,
            scale,
            ln_scale: scale.ln(),
            weight,
            k,
            recip_pi,
        }
    }

    /// k ln cos θ.
    fn ln_power(&self, at: &Direction<W>) -> W {
        if self.law.exponent() == 0.0 {
            W::default()
        } else {
            self.k * at.ln_cos()
        }
    }

    /// Per radian or steradian.
    pub fn density(&self, at: &Direction<W>) -> W {
        let c = at.cos;
        match self.law {
            Id::CircleArc => self.scale,
            Id::CircleShell | Id::Lambert => c * self.scale,
            Id::Disk | Id::SphereShell => c * c * self.scale,
            Id::Ball => c * c * c * self.scale,
            // One exponential, so that a large factor and a small power meet without underflow.
            Id::CosPower(_) => (self.ln_scale + self.ln_power(at)).exp(),
        }
    }

    pub fn pdf(&self, at: &Direction<W>) -> W {
        if self.law.planar() {
            self.density(at)
        } else {
            self.density(at) * at.sin
        }
    }

    pub fn ln_pdf(&self, at: &Direction<W>) -> W {
        let density = self.ln_scale + self.ln_power(at);
        if self.law.planar() {
            density
        } else {
            density + at.ln_sin()
        }
    }

    /// What the terms of `ln_pdf` may add up to before they cancel.
    pub fn ln_pdf_terms(&self) -> f64 {
        match self.law {
            Id::CosPower(_) => self.ln_scale.near().abs(),
            _ => 0.0,
        }
    }

    /// (lower, upper) tails of a planar law at −θ, of a spatial one at θ; each relatively accurate.
    pub fn tails(&self, at: &Direction<W>) -> (W, W) {
        let (one, half) = (W::of(1.0), W::of(0.5));
        let (c, s) = (at.cos, at.sin);
        let c2 = c * c;
        let nearer = match self.law {
            Id::Disk => kepler_tail(at.eta, c, s),
            Id::CircleShell => c2 * half / (one + s),
            Id::CircleArc => at.eta * self.recip_pi,
            Id::Ball => return (s * s * (one + c2), c2 * c2),
            Id::SphereShell => return (s * s * (one + c + c2) / (one + c), c2 * c),
            Id::Lambert => return (s * s, c2),
            Id::CosPower(_) => {
                // For tiny θ in an order that does not underflow before its value does.
                let a = if s.near() < 1e-40 {
                    (self.k + one) * s * s * half
                } else {
                    -(self.ln_power(at) + at.ln_cos())
                };
                return (a.one_minus_exp_neg(), (-a).exp());
            }
        };
        (nearer, one - nearer)
    }

    /// 2D: (cos θ / 2)/density; 3D: (cos θ / π)/density.
    pub fn lambert_weight(&self, at: &Direction<W>) -> W {
        let c = at.cos;
        match self.law {
            Id::CircleShell | Id::Lambert => self.weight,
            Id::CircleArc => self.weight * c,
            Id::Disk | Id::SphereShell => self.weight / c,
            Id::Ball => self.weight / (c * c),
            Id::CosPower(_) => {
                let log = self.weight.ln() + (W::of(1.0) - self.k) * at.ln_cos();
                if log.near() > 709.8 {
                    return W::of(f64::INFINITY);
                }
                log.exp()
            }
        }
    }
}

pub fn density<W: Wide>(law: Id, at: &Direction<W>) -> W {
    Formula::new(law).density(at)
}

pub fn pdf<W: Wide>(law: Id, at: &Direction<W>) -> W {
    Formula::new(law).pdf(at)
}

pub fn ln_pdf<W: Wide>(law: Id, at: &Direction<W>) -> W {
    Formula::new(law).ln_pdf(at)
}

pub fn tails<W: Wide>(law: Id, at: &Direction<W>) -> (W, W) {
    Formula::new(law).tails(at)
}
