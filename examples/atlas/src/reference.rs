//! The truth about a law, from the references that judge the accuracy tests.
//!
//! p is the tail of the horizon: in the plane that of the nearer end, P(Θ ≤ −|θ|); in space P(Θ >
//! θ).

use kit::accuracy::double::Double;
use kit::accuracy::inverse::warp;
use kit::accuracy::reference::{Direction, Id, tails};
use std::f64::consts::FRAC_PI_2;

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
    fn id(self) -> Id {
        match self {
            Shape::Disk => Id::Disk,
            Shape::CircleShell => Id::CircleShell,
            Shape::CircleArc => Id::CircleArc,
            Shape::Power(k) => Id::CosPower(k),
        }
    }

    /// cdf of θ in double precision: enough for the cells of a histogram.
    pub(crate) fn cdf(self, theta: f64) -> f64 {
        let at = Direction::<f64>::at_angle(theta.abs().min(FRAC_PI_2));
        let (lower, upper) = tails(self.id(), &at);
        // A planar law's tails are those at −|θ|.
        if self.id().planar() && theta > 0.0 {
            upper
        } else {
            lower
        }
    }

    /// The part of the support that a histogram covers, in radians: beyond a narrow lobe's
    /// millionth there is nothing to see.
    pub(crate) fn window(self) -> (f64, f64) {
        match self {
            Shape::Power(_) => {
                let (cos, sin) = warp::<f64>(self.id(), 1e-6, true);
                let end = sin.atan2(cos);
                (0.0, if end > 1.3 { FRAC_PI_2 } else { end })
            }
            _ => (-FRAC_PI_2, FRAC_PI_2),
        }
    }

    /// cos θ at the tail p, to some 30 digits.
    pub(crate) fn cos_at(self, p: f64) -> Double {
        warp::<Double>(self.id(), p, true).0
    }
}
