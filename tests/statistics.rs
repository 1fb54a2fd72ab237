//! χ², Kolmogorov–Smirnov, moments and tails of every law; and wrong samplers, which must fail them.
//!
//! The thorough run: `cargo test --release --test statistics -- --ignored --nocapture`.

#[path = "stats/mutants.rs"]
mod mutants;
mod stats;

use coslobe::rand_core::Rng;
use coslobe::{PlanarPoint, Spatial};
use stats::harness::{examine, examine_tail};
use stats::laws::{Claim, Direction, Float, Visitor, each};
use stats::words;

/// The random bits reach down to 2⁻⁶⁵ in `f32` and 2⁻¹²⁹ in `f64`.
const DEPTHS_F32: &[u32] = &[24, 40, 60];
const DEPTHS_F64: &[u32] = &[24, 40, 60, 90, 124];

const EXPONENTS: [f64; 5] = [0.0, 0.5, 7.3, 200.0, 1e4];

pub(crate) fn in_plane<T: Float>([x, y]: [T; 2]) -> Direction {
    [x.into(), y.into(), 0.0]
}

pub(crate) fn in_space<T: Float>(d: [T; 3]) -> Direction {
    d.map(Into::into)
}

/// Every law with `n` samples, and its tails with fewer.
struct Laws {
    n: usize,
    tail_n: usize,
    depths: &'static [u32],
}

impl Laws {
    fn check(&self, claim: &Claim, draw: impl Fn(&mut dyn Rng) -> Direction) {
        let mut rng = words::pcg(&claim.name);
        examine(claim, self.n, || draw(&mut rng)).accepted();
        for &depth in self.depths {
            examine_tail(claim, depth, self.tail_n, words::deep(depth), &draw).accepted();
        }
    }
}

impl<T: Float> Visitor<T> for Laws {
    fn planar<L: PlanarPoint<T> + Copy + 'static>(&mut self, claim: Claim, law: L) {
        self.check(&claim, |mut rng| in_plane(law.sample(&mut rng)));
    }

    fn spatial<L: Spatial<T> + Copy + 'static>(&mut self, claim: Claim, law: L) {
        self.check(&claim, |mut rng| in_space(Spatial::sample(&law, &mut rng)));
    }
}

fn run<T: Float>(n: usize, tail_n: usize, depths: &'static [u32]) {
    each::<T>(&mut Laws { n, tail_n, depths }, &EXPONENTS);
}

#[test]
fn laws_f32() {
    run::<f32>(1_000_000, 50_000, DEPTHS_F32);
}

#[test]
fn laws_f64() {
    run::<f64>(1_000_000, 50_000, DEPTHS_F64);
}

#[test]
#[ignore = "opt-in: 10^7 samples, cargo test --release --test statistics -- --ignored"]
fn laws_f32_thorough() {
    run::<f32>(10_000_000, 1_000_000, DEPTHS_F32);
}

#[test]
#[ignore = "opt-in: 10^7 samples, cargo test --release --test statistics -- --ignored"]
fn laws_f64_thorough() {
    run::<f64>(10_000_000, 1_000_000, DEPTHS_F64);
}
