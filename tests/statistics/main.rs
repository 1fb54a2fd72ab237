//! Promise: every sampler draws its law.
//!
//! χ², Kolmogorov–Smirnov, moments and tails of every law; and wrong samplers, which must fail
//! them.
//!
//! The thorough run: `cargo test --release --test statistics -- --ignored --nocapture`.

mod drawn;
mod halves;
mod integers;
mod measures;
mod mutants;
mod poor_generators;
mod rotated;

use coslobe::rand_core::Rng;
use coslobe::{Fast, Precise, Spatial};
use kit::catalogue::every_law;
use kit::stats::claim::{Claim, Direction};
use kit::stats::harness::{examine, examine_tail};
use kit::stats::words;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};

/// The random bits reach down to 2⁻⁶⁵ in `f32` and 2⁻¹²⁹ in `f64`.
const DEPTHS_F32: &[u32] = &[24, 40, 60];
const DEPTHS_F64: &[u32] = &[24, 40, 60, 90, 124];
/// One word: down to 2⁻³², and so coarse at 2⁻²⁷ that one value falls in each cell.
const DEPTHS_FAST: &[u32] = &[16, 24, 27];

const EXPONENTS: [f64; 5] = [0.0, 0.5, 7.3, 200.0, 1e4];

pub(crate) fn in_plane<T: Number>([x, y]: [T; 2]) -> Direction {
    [x.into(), y.into(), 0.0]
}

pub(crate) fn in_space<T: Number>(d: [T; 3]) -> Direction {
    d.map(Into::into)
}

/// Every law with `n` samples, and its tails with fewer.
struct Laws {
    n: usize,
    tail_n: usize,
    depths: &'static [u32],
    /// Bits of a tail's first word.
    bits: u32,
}

impl Laws {
    fn check(&self, id: Id, claim: &Claim, draw: impl Fn(&mut dyn Rng) -> Direction) {
        let mut rng = words::pcg(&claim.name);
        examine(claim, self.n, || draw(&mut rng)).accepted();
        // Of two halves of a word: their tails are those of `halves`.
        let in_halves = id.has_two_uniforms();
        for &depth in self.depths.iter().filter(|_| !in_halves) {
            examine_tail(
                claim,
                depth,
                self.tail_n,
                words::deep_in(self.bits, depth),
                &draw,
            )
            .accepted();
        }
    }
}

impl<T: Number> LawVisitor<T> for Laws {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        self.check(id, &claim, |mut rng| in_plane(law.sample(&mut rng)));
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        self.check(id, &claim, |mut rng| {
            in_space(Spatial::sample(&law, &mut rng))
        });
    }
}

fn run<T: Number>(n: usize, tail_n: usize, depths: &'static [u32]) {
    let bits = if T::TAIL_WORDS == (1, 0) { 32 } else { 64 };
    let mut laws = Laws {
        n,
        tail_n,
        depths,
        bits,
    };
    every_law::<T>(&mut laws, &EXPONENTS);
}

#[test]
fn laws_f32() {
    run::<f32>(1_000_000, 50_000, DEPTHS_F32);
}

#[test]
fn laws_f64() {
    run::<f64>(1_000_000, 50_000, DEPTHS_F64);
}

/// Fewer samples: the words and uniforms are those of `f32`, and `tiers` compares the directions.
#[test]
fn laws_precise_f32() {
    run::<Precise<f32>>(200_000, 50_000, &[60]);
}

#[test]
fn laws_precise_f64() {
    run::<Precise<f64>>(200_000, 50_000, &[124]);
}

/// A direction may be off by 2⁻¹², so at 10⁶ samples the means have that as a tolerance, value by
/// value. The cells and KS need none: their edges move by at most 2⁻¹² too, 0.25 of the 10⁻³ that
/// chance moves a KS distance, and by nearly the same at both edges of a cell, whose count of 1000
/// chance moves by 3%.
#[test]
fn laws_fast_f32() {
    run::<Fast<f32>>(1_000_000, 50_000, DEPTHS_FAST);
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
