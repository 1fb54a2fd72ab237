//! The laws' true values at a direction, written from the formulas in wider arithmetic.

use super::wide::Wide;

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

    fn exponent(self) -> f64 {
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
#[derive(Clone, Copy)]
pub struct Direction<W> {
    pub theta: W,
    /// π/2 − θ.
    pub eta: W,
    pub cos: W,
    pub sin: W,
    pub ln_cos: W,
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

    fn new(theta: W, eta: W, cos: W, sin: W) -> Self {
        let ln_cos = if cos < sin {
            cos.ln()
        } else {
            (sin * sin).ln_one_minus() * W::of(0.5)
        };
        Direction {
            theta,
            eta,
            cos,
            sin,
            ln_cos,
        }
    }
}

/// Normalisation of the density per radian or steradian.
fn scale<W: Wide>(law: Id) -> W {
    let pi = W::pi();
    match law {
        Id::Disk => W::of(2.0) / pi,
        Id::CircleShell => W::of(0.5),
        Id::CircleArc => W::of(1.0) / pi,
        _ => (W::of(law.exponent()) + W::of(1.0)) / (pi * W::of(2.0)),
    }
}

fn cos_power<W: Wide>(law: Id, at: &Direction<W>) -> W {
    let c = at.cos;
    match law {
        Id::CircleArc => W::of(1.0),
        Id::CircleShell | Id::Lambert => c,
        Id::Disk | Id::SphereShell => c * c,
        Id::Ball => c * c * c,
        Id::CosPower(0.0) => W::of(1.0),
        Id::CosPower(k) => (W::of(k) * at.ln_cos).exp(),
    }
}

/// Per radian or steradian.
pub fn density<W: Wide>(law: Id, at: &Direction<W>) -> W {
    if let Id::CosPower(k) = law {
        // One exponential, so that a large factor and a small power meet without underflow.
        let power = if k == 0.0 {
            W::of(0.0)
        } else {
            W::of(k) * at.ln_cos
        };
        return (scale::<W>(law).ln() + power).exp();
    }
    scale::<W>(law) * cos_power(law, at)
}

/// Density of a cosine alone.
pub fn density_at_cos<W: Wide>(law: Id, cos: f64) -> W {
    let c = W::of(cos);
    let zero = W::default();
    let at = Direction {
        theta: zero,
        eta: zero,
        cos: c,
        sin: zero,
        ln_cos: zero,
    };
    density(law, &at)
}

pub fn pdf<W: Wide>(law: Id, at: &Direction<W>) -> W {
    if law.planar() {
        density(law, at)
    } else {
        density(law, at) * at.sin
    }
}

pub fn ln_pdf<W: Wide>(law: Id, at: &Direction<W>) -> W {
    let k = law.exponent();
    let power = if k == 0.0 {
        W::of(0.0)
    } else {
        at.ln_cos * W::of(k)
    };
    let density = scale::<W>(law).ln() + power;
    if law.planar() {
        density
    } else if at.sin.near() == 0.0 {
        W::of(f64::NEG_INFINITY)
    } else {
        density + at.sin.ln()
    }
}

/// (lower, upper) tails of a planar law at −θ, of a spatial one at θ; each relatively accurate.
pub fn tails<W: Wide>(law: Id, at: &Direction<W>) -> (W, W) {
    let (one, half) = (W::of(1.0), W::of(0.5));
    let (c, s) = (at.cos, at.sin);
    let c2 = c * c;
    let nearer = match law {
        Id::Disk => kepler_tail(at.eta),
        Id::CircleShell => c2 * half / (one + s),
        Id::CircleArc => at.eta / W::pi(),
        Id::Ball => return (s * s * (one + c2), c2 * c2),
        Id::SphereShell => return (s * s * (one + c + c2) / (one + c), c2 * c),
        Id::Lambert => return (s * s, c2),
        Id::CosPower(k) => {
            // For tiny θ in an order that does not underflow before its value does.
            let a = if s.near() < 1e-40 {
                (W::of(k) + one) * s * s * half
            } else {
                -(W::of(k) * at.ln_cos + at.ln_cos)
            };
            return (a.one_minus_exp_neg(), (-a).exp());
        }
    };
    (nearer, one - nearer)
}

/// (2η − sin 2η)/2π.
pub fn kepler_tail<W: Wide>(eta: W) -> W {
    let y = eta + eta;
    let difference = if y.near() > 0.5 {
        let sin = if y.near() > 1.6 {
            // sin y = 2 sin η cos η keeps the argument in range.
            let (s, c) = eta.sin_cos();
            s * c * W::of(2.0)
        } else {
            y.sin_cos().0
        };
        y - sin
    } else {
        let square = y * y;
        let mut term = y * square / W::of(6.0);
        let mut sum = term;
        for i in 2..16 {
            let n = 2.0 * f64::from(i);
            term = -(term * square) / W::of(n * (n + 1.0));
            sum = sum + term;
        }
        sum
    };
    difference / (W::pi() * W::of(2.0))
}

/// 2D: (cos θ / 2)/density; 3D: (cos θ / π)/density.
pub fn lambert_weight<W: Wide>(law: Id, at: &Direction<W>) -> W {
    let lambert = if law.planar() {
        W::of(0.5)
    } else {
        W::of(1.0) / W::pi()
    };
    match law {
        Id::CosPower(k) => {
            let next = W::of(k) + W::of(1.0);
            let log = (W::of(2.0) / next).ln() + (W::of(1.0) - W::of(k)) * at.ln_cos;
            if log.near() > 709.8 {
                return W::of(f64::INFINITY);
            }
            log.exp()
        }
        _ => lambert * at.cos / (scale::<W>(law) * cos_power(law, at)),
    }
}
