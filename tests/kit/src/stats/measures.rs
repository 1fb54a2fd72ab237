//! Raw points by each measure of the paper and of the circle and sphere, without the crate's
//! samplers.

use coslobe::Measure;
use coslobe::rand_core::Rng;
use rand_pcg::Pcg64;
use std::f64::consts::TAU;

/// Thickness of the radial shell for ρ = 1: moves its law by 1e-3 at most, unseen at n = 1e5.
const SHELL: f64 = 2e-3;

fn uniform(rng: &mut Pcg64) -> f64 {
    (rng.next_u64() >> 11) as f64 * 0.5f64.powi(53)
}

/// The first point of a box about the body of radius 1 that `keep` accepts; z = 0 in the plane.
fn rejected(planar: bool, rng: &mut Pcg64, keep: impl Fn([f64; 3]) -> bool) -> [f64; 3] {
    let half = 1.0 + SHELL;
    loop {
        let mut side = || half * (2.0 * uniform(rng) - 1.0);
        let point = [side(), 1.0 + side(), if planar { 0.0 } else { side() }];
        if keep(point) {
            return point;
        }
    }
}

pub fn radius([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

pub fn from_centre([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, y - 1.0, z]
}

/// A raw point of the unit disk, circle, ball or sphere that touches the origin.
pub fn raw_point(measure: Measure, rng: &mut Pcg64) -> [f64; 3] {
    let inside = |point| radius(from_centre(point)) < 1.0;
    // 2 cos θ = 2y/r.
    let in_shell = |point: [f64; 3]| {
        let past = radius(point) - 2.0 * point[1] / radius(point);
        past > 0.0 && past < SHELL && point[1] > 0.0
    };
    match measure {
        Measure::Area => rejected(true, rng, inside),
        Measure::Volume => rejected(false, rng, inside),
        Measure::CircleShell => rejected(true, rng, in_shell),
        Measure::SphereShell => rejected(false, rng, in_shell),
        Measure::ArcLength => {
            let (sin, cos) = (TAU * uniform(rng)).sin_cos();
            [cos, 1.0 + sin, 0.0]
        }
        Measure::SurfaceArea => {
            // Archimedes: heights of a sphere's surface are uniform.
            let (height, (sin, cos)) = (2.0 * uniform(rng) - 1.0, (TAU * uniform(rng)).sin_cos());
            let across = (1.0 - height * height).sqrt();
            [across * cos, 1.0 + height, across * sin]
        }
    }
}
