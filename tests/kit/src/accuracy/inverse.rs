//! The laws' true directions at a tail: closed forms, and Newton's method for the disk.

use super::reference::Id;
use super::wide::Wide;

/// The direction at nearer tail p ≤ ½ of a planar law (θ ≥ 0), or at the tails of a spatial one
/// of which the nearer is p, on the `upper` side or not.
pub fn warp<W: Wide>(law: Id, p: f64, upper: bool) -> (W, W) {
    let (one, half, p_w) = (W::of(1.0), W::of(0.5), W::of(p));
    let rest = one - p_w;
    let (lower, sf) = if upper { (rest, p_w) } else { (p_w, rest) };
    if p == 0.0 {
        return if upper || law.planar() {
            (p_w, one)
        } else {
            (one, p_w)
        };
    }
    match law {
        Id::Disk => kepler(p),
        Id::CircleShell => ((p_w * rest).root() * W::of(2.0), one - (p_w + p_w)),
        Id::CircleArc => {
            if p < 0.25 {
                (p_w * W::pi()).sin_cos()
            } else {
                let (s, c) = ((half - p_w) * W::pi()).sin_cos();
                (c, s)
            }
        }
        Id::Ball => {
            let square = sf.root();
            (square.root(), lower.root() / (one + square).root())
        }
        Id::SphereShell => {
            let c = sf.cube_root();
            (c, lower.root() * ((one + c) / (one + c + c * c)).root())
        }
        Id::Lambert => (sf.root(), lower.root()),
        Id::CosPower(k) => {
            // (1 − sf)/(k + 1) may underflow before its root does: scale by the root.
            let log = if sf.near() < 0.5 {
                -sf.ln()
            } else {
                -lower.ln_one_minus()
            };
            let next = W::of(k) + one;
            let a = log / next;
            let sin = if a.near() < 1e-40 {
                (log * W::of(2.0)).root() / next.root()
            } else {
                (a * W::of(2.0)).one_minus_exp_neg().root()
            };
            ((-a).exp(), sin)
        }
    }
}

/// θ of the direction at which [`warp`] finds `at`; where the law names it, not through the pair.
pub fn angle<W: Wide>(law: Id, p: f64, at: (W, W)) -> W {
    match law {
        Id::CircleArc => (W::of(0.5) - W::of(p)) * W::pi(),
        Id::Disk if p == 0.0 => W::pi() * W::of(0.5),
        Id::Disk if p < 0.15 => W::pi() * W::of(0.5) - W::kepler(p),
        _ => W::angle(at.0, at.1),
    }
}

/// (cos θ, sin θ) of the disk's law at nearer tail p, by Newton's method from the end or the axis.
fn kepler<W: Wide>(p: f64) -> (W, W) {
    if p < 0.15 {
        return W::kepler(p).sin_cos();
    }
    let target = (W::of(0.5) - W::of(p)) * W::pi();
    let goal = target.near();
    // Converged in f64, then one step more in W.
    let mut guess = goal * (0.5 + goal * goal / 24.0);
    for _ in 0..4 {
        let (s, c) = guess.sin_cos();
        guess -= (guess + s * c - goal) / (c * c * 2.0);
    }
    let guess = W::of(guess);
    let (s, c) = guess.sin_cos();
    let theta = guess - (guess + s * c - target) / (c * c * W::of(2.0));
    let (s, c) = theta.sin_cos();
    (c, s)
}
