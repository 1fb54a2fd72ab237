//! The 16-bit laws against closed `f64` forms, on every input:
//! `cargo test --test errors q15 -- --nocapture`.

mod corners;
mod pairs;
mod weights_and_points;
mod wrong;

use fixed::types::I1F15;
use kit::integer::documented;
use kit::integer::short::{Pair, Q15, Subject, subjects};
use pairs::{length_off, pair, unit_pairs};

const Q16: f64 = 65536.0;

/// Largest error in units of the last place, and its input.
#[derive(Clone, Copy, Debug)]
struct Worst(f64, u32);

impl Worst {
    fn larger(self, other: Worst) -> Worst {
        // Written so that NaN stays.
        if self.0 >= other.0 { self } else { other }
    }

    fn over(inputs: impl Iterator<Item = u32>, error: impl Fn(u32) -> f64) -> Worst {
        inputs
            .map(|at| Worst(error(at), at))
            .fold(Worst(-1.0, 0), Worst::larger)
    }
}

fn off(got: u16, want: f64) -> f64 {
    (f64::from(got) - (want * Q16).min(Q16 - 1.0)).abs()
}

fn pair_off(got: Pair, (cos, sin): (f64, f64)) -> f64 {
    let of = |got: I1F15, want: f64| (f64::from(got.to_bits()) - want * Q15).abs();
    of(got.cos, cos).max(of(got.sin, sin))
}

fn turn_off(got: i16, want: f64) -> f64 {
    (f64::from(got) - want * Q16).abs()
}

/// [p, 1 − p].
fn tails(p: u16) -> [f64; 2] {
    [f64::from(p) / Q16, (Q16 - f64::from(p)) / Q16]
}

type Row = (&'static str, fn(&Subject, u32) -> f64);

const WORDS: [Row; 8] = [
    ("warp", |law, u| {
        let [lower, upper] = tails(u as u16);
        pair_off((law.warp)(u as u16), law.pair(lower, upper))
    }),
    ("warp_sf", |law, q| {
        let [upper, lower] = tails(q as u16);
        pair_off((law.warp_sf)(q as u16), law.pair(lower, upper))
    }),
    ("unit", |law, u| {
        length_off((law.warp)(u as u16)).max(length_off((law.warp_sf)(u as u16)))
    }),
    ("pdf", |law, t| {
        off((law.pdf)(t as i16), law.pdf_at(f64::from(t as i16) / Q16))
    }),
    ("cdf", |law, t| {
        off(
            (law.cdf)(t as i16),
            law.truth.tails(f64::from(t as i16) / Q16)[0],
        )
    }),
    ("sf", |law, t| {
        off(
            (law.sf)(t as i16),
            law.truth.tails(f64::from(t as i16) / Q16)[1],
        )
    }),
    ("quantile", |law, p| {
        let [lower, upper] = tails(p as u16);
        turn_off((law.quantile)(p as u16), law.turn(lower, upper))
    }),
    ("isf", |law, q| {
        let [upper, lower] = tails(q as u16);
        turn_off((law.isf)(q as u16), law.turn(lower, upper))
    }),
];

/// A pair's tails are those of its angle; its density that of its cosine.
const PAIRS: [Row; 2] = [
    ("unwarp", |law, x| {
        let at = pair(x);
        let angle = f64::from(at.sin).atan2(f64::from(at.cos));
        let [lower, upper] = law.truth.tails(angle / std::f64::consts::TAU);
        off((law.unwarp)(at), lower).max(off((law.unwarp_sf)(at), upper))
    }),
    ("density", |law, x| {
        let at = pair(x);
        if at.cos == 0 && law.k > 0 {
            return f64::from((law.density)(at));
        }
        let want = law.density_at(f64::from(at.cos));
        // At least one unit above the horizon.
        off((law.density)(at), want.max(1.0 / Q16))
    }),
];

/// The column of each figure in the documented table.
const COLUMNS: [usize; 10] = [0, 0, 1, 4, 5, 5, 6, 6, 2, 3];

/// All ten figures of a law.
fn measure(law: &Subject) -> Vec<(&'static str, Worst)> {
    let words = WORDS.map(|(name, error)| (name, Worst::over(0..1 << 16, |x| error(law, x))));
    let pairs = unit_pairs(law.planar);
    let pairs =
        PAIRS.map(|(name, error)| (name, Worst::over(pairs.iter().copied(), |x| error(law, x))));
    words.into_iter().chain(pairs).collect()
}

#[test]
fn laws_on_every_input() {
    let documented = documented("Fixed16");
    for law in subjects() {
        let (_, bounds) = documented
            .iter()
            .find(|(name, _)| name == law.name)
            .expect("a row");
        let mut found = [0.0f64; 7];
        for ((operation, Worst(error, at)), column) in measure(&law).into_iter().zip(COLUMNS) {
            println!("{} {operation}: {error:.3} at {at:#06x}", law.name);
            assert!(!error.is_nan(), "{} {operation} at {at:#06x}", law.name);
            found[column] = found[column].max(error);
        }
        assert_eq!(bounds.len(), found.len());
        for (found, bound) in found.iter().zip(bounds) {
            assert!(
                (found - bound).abs() <= 0.01,
                "{}: {found}, documented {bound}",
                law.name
            );
        }
    }
}
