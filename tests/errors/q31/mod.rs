//! The fixed-point laws against closed `f64` forms: in strides always, and on every word by
//! `cargo test --release --test errors q31 -- --ignored --nocapture --test-threads 1`.

mod corners;
mod cos_power;
mod weights_and_points;

use coslobe::CosSin;
use fixed::types::{I1F31, U0F32};
use kit::integer::documented;
use kit::integer::reference::{Q31, Q32, Subject, subjects};
use rayon::prelude::*;

/// Largest error in units of the last place, and its input.
#[derive(Clone, Copy)]
struct Worst(f64, u32);

impl Worst {
    fn larger(self, other: Worst) -> Worst {
        if other.0 > self.0 { other } else { self }
    }
}

const NONE: Worst = Worst(-1.0, 0);

/// Over every `stride`th word, and 4096 at each of 32 corners.
fn worst(stride: usize, error: impl Fn(u32) -> f64 + Sync) -> Worst {
    let of = |at: u32| Worst(error(at), at);
    let corners = (0..32u32)
        .flat_map(|i| (0..4096u32).map(move |j| (i << 27).wrapping_add(j).wrapping_sub(2048)));
    let corners = corners.map(of).fold(NONE, Worst::larger);
    (0..1u64 << 12)
        .into_par_iter()
        .map(|block| {
            let from = block << 20;
            let first = from.next_multiple_of(stride as u64);
            let words = (first..from + (1 << 20)).step_by(stride);
            words.map(|x| of(x as u32)).fold(NONE, Worst::larger)
        })
        .reduce(|| NONE, Worst::larger)
        .larger(corners)
}

fn off(got: U0F32, want: f64) -> f64 {
    (f64::from(got.to_bits()) - (want * Q32).min(Q32 - 1.0)).abs()
}

fn pair_off(got: CosSin<I1F31>, (cos, sin): (f64, f64)) -> f64 {
    let of = |got: I1F31, want: f64| (f64::from(got.to_bits()) - want * Q31).abs();
    of(got.cos, cos).max(of(got.sin, sin))
}

fn turn_off(got: fixed::types::I0F32, want: f64) -> f64 {
    (f64::from(got.to_bits()) - want * Q32).abs()
}

/// 1 for a word that stands for 2³², as 1 − p does for p = 0.
fn tails(p: u32) -> (f64, f64) {
    (f64::from(p) / Q32, (Q32 - f64::from(p)) / Q32)
}

/// The pair nearest to the angle `x`·2⁻³⁴ turns (planar: on either side), and its exact [cdf, sf].
fn near_pair(law: &Subject, x: u32) -> (CosSin<I1F31>, [f64; 2]) {
    let turn = if law.planar {
        f64::from(x as i32) / Q32 / 2.0
    } else {
        f64::from(x) / Q32 / 4.0
    };
    let (sin, cos) = (turn * std::f64::consts::TAU).sin_cos();
    let of = |x: f64| I1F31::from_bits((x * Q31).round().min(Q31 - 1.0) as i32);
    (
        CosSin {
            cos: of(cos),
            sin: of(sin),
        },
        law.tails(turn),
    )
}

type Row = (&'static str, fn(&Subject, u32) -> f64);

const ROWS: [Row; 10] = [
    ("warp", |law, u| {
        let (lower, upper) = tails(u);
        pair_off((law.warp)(u), law.pair(lower, upper))
    }),
    ("warp_sf", |law, q| {
        let (upper, lower) = tails(q);
        pair_off((law.warp_sf)(q), law.pair(lower, upper))
    }),
    ("unit", |law, u| {
        let at = (law.warp)(u);
        (f64::from(at.cos.to_bits()).hypot(f64::from(at.sin.to_bits())) - Q31).abs()
    }),
    ("unwarp", |law, x| {
        let (at, [lower, upper]) = near_pair(law, x);
        off((law.unwarp)(at), lower).max(off((law.unwarp_sf)(at), upper))
    }),
    ("density", |law, x| {
        let (at, _) = near_pair(law, x);
        off(
            (law.density)(at),
            law.density_at(f64::from(at.cos.to_bits()) / Q31),
        )
    }),
    ("pdf", |law, t| {
        off((law.pdf)(t as i32), law.pdf_at(f64::from(t as i32) / Q32))
    }),
    ("cdf", |law, t| {
        off((law.cdf)(t as i32), law.tails(f64::from(t as i32) / Q32)[0])
    }),
    ("sf", |law, t| {
        off((law.sf)(t as i32), law.tails(f64::from(t as i32) / Q32)[1])
    }),
    ("quantile", |law, p| {
        let (lower, upper) = tails(p);
        turn_off((law.quantile)(p), law.turn(lower, upper))
    }),
    ("isf", |law, q| {
        let (upper, lower) = tails(q);
        turn_off((law.isf)(q), law.turn(lower, upper))
    }),
];

/// The column of each row in the documented table.
const COLUMNS: [usize; 10] = [0, 0, 1, 2, 3, 4, 5, 5, 6, 6];

fn hold(rows: &[usize], stride: usize) {
    let mut exceeding = Vec::new();
    let bounds = documented("Fixed");
    for law in subjects() {
        let (_, bounds) = bounds
            .iter()
            .find(|(name, _)| name == law.name)
            .expect("a row");
        for &row in rows {
            let (name, (operation, error), bound) = (law.name, ROWS[row], bounds[COLUMNS[row]]);
            let Worst(error, at) = worst(stride, |x| error(&law, x));
            println!("{name} {operation}: {error:.3} at {at:#010x} (bound {bound})");
            if error.is_nan() || error > bound {
                exceeding.push(format!("{name} {operation}: {error} at {at:#010x}"));
            }
        }
    }
    assert!(exceeding.is_empty(), "{exceeding:#?}");
}

#[test]
fn laws_in_strides() {
    hold(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9], 4093);
}

#[test]
#[ignore = "2³² words for each law: cargo test --release --test errors q31 -- --ignored --nocapture"]
fn warps_exhaustively() {
    hold(&[0, 2], 1);
}

#[test]
#[ignore = "2²⁶ words for each law and operation: cargo test --release --test errors q31 -- --ignored --nocapture"]
fn laws_in_fine_strides() {
    hold(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9], 61);
}
