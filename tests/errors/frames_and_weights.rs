//! The error bounds that `Frame` and the heuristics state, on random arguments.

use coslobe::{Frame, balance_heuristic, power_heuristic};
use kit::accuracy::format::{Format, error_in_ulps};
use kit::accuracy::wide::Wide;
use kit::catalogue::every_number;
use kit::{Number, NumberVisitor};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

const N: usize = 200_000;

/// Uniform in (0, 1).
fn unit(rng: &mut Pcg64) -> f64 {
    ((rng.next_u64() >> 12) as f64 + 0.5) / 2f64.powi(52)
}

/// A random unit vector, a third of them close to ±z where the construction divides by 1 + |z|.
fn normal(rng: &mut Pcg64, i: usize) -> [f64; 3] {
    let spread = if i % 3 == 0 { 1e-6 } else { 1.0 };
    let v = [spread, spread, 1.0].map(|s| s * (2.0 * unit(rng) - 1.0));
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    v.map(|c| c / length)
}

type Exact<T> = <<T as Number>::Raw as Format>::Wide;

fn orthonormal<T: Number>() {
    let mut rng = Pcg64::seed_from_u64(23);
    let mut worst = 0.0f64;
    for i in 0..N {
        let n = normal(&mut rng, i).map(T::of);
        let axes = Frame::from_unit(n)
            .axes()
            .map(|a| a.map(|c| Exact::<T>::of(c.wide())));
        for (i, a) in axes.iter().enumerate() {
            for (j, b) in axes.iter().enumerate() {
                let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let error = dot.minus(f64::from(u8::from(i == j))).abs();
                worst = worst.max(error / 2f64.powi(1 - T::Raw::DIGITS));
            }
        }
    }
    println!(
        "{}: axes orthonormal to {worst:.3} ulp of 1, {N} normals",
        T::NAME
    );
    assert!(worst <= 4.0, "{worst} ulp of 1");
}

fn heuristics<T: Number>() {
    let mut rng = Pcg64::seed_from_u64(29);
    let (mut balance, mut power) = (0.0f64, 0.0f64);
    for _ in 0..N {
        let [a, b] = [0; 2].map(|_| T::of(2f64.powf(40.0 * unit(&mut rng) - 20.0)));
        let (wa, wb) = (Exact::<T>::of(a.wide()), Exact::<T>::of(b.wide()));
        balance = balance.max(error_in_ulps(balance_heuristic(a, b).raw(), wa / (wa + wb)));
        let (a2, b2) = (wa * wa, wb * wb);
        power = power.max(error_in_ulps(power_heuristic(a, b).raw(), a2 / (a2 + b2)));
    }
    println!(
        "{}: balance {balance:.3} ulp, power {power:.3} ulp, {N} pairs",
        T::NAME
    );
    assert!(balance < 3.0 && power < 4.0, "{balance} {power}");
}

struct Orthonormal;

impl NumberVisitor for Orthonormal {
    fn number<T: Number>(&mut self) {
        orthonormal::<T>();
    }
}

#[test]
fn frames_are_orthonormal() {
    every_number(&mut Orthonormal);
}

struct Heuristics;

impl NumberVisitor for Heuristics {
    fn number<T: Number>(&mut self) {
        heuristics::<T>();
    }
}

#[test]
fn heuristics_keep_their_bounds() {
    every_number(&mut Heuristics);
}

/// `Frame` says so: an axis comes out without negative zeros.
struct NoNegativeZeros;

impl NumberVisitor for NoNegativeZeros {
    fn number<T: Number>(&mut self) {
        for (axis, side) in [
            (0, 1.0),
            (0, -1.0),
            (1, 1.0),
            (1, -1.0),
            (2, 1.0),
            (2, -1.0),
        ] {
            let mut normal = [T::of(0.0); 3];
            normal[axis] = T::of(side);
            let axes = Frame::from_unit(normal).axes();
            let minus = |c: &T| c.wide() == 0.0 && c.negative();
            assert!(!axes.as_flattened().iter().any(minus), "{axes:?}");
        }
    }
}

#[test]
fn axes_have_no_negative_zeros() {
    every_number(&mut NoNegativeZeros);
}
