//! The laws' true values at a direction, written from the formulas in wider arithmetic.

use super::reference::{Direction, Id};
use super::wide::{Wide, kepler_tail};

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
            Id::CosPower(k) if k > 0.0 && c == W::default() => c,
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
            Id::CosPower(_) if c == W::default() => return (one, c),
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
        if c == W::default() && self.law.exponent() > 1.0 {
            return W::of(f64::INFINITY);
        }
        match self.law {
            Id::CircleShell | Id::Lambert => self.weight,
            Id::CircleArc => self.weight * c,
            Id::Disk | Id::SphereShell => self.weight / c,
            Id::Ball => self.weight / c / c, // c² would underflow before the weight overflows
            Id::CosPower(k) if c == W::default() => {
                if k < 1.0 {
                    c
                } else {
                    self.weight
                }
            }
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
