//! The fixed-point laws against closed `f64` forms: in strides always, and on every word by
//! `cargo test --release --features fixed --test fixed -- --ignored --nocapture --test-threads 1`.
#![cfg(feature = "fixed")]

#[path = "fixed/reference.rs"]
mod reference;

use coslobe::CosSin;
use coslobe::Fixed;
use fixed::types::{I0F32, I1F31, U0F32, U16F16};
use rayon::prelude::*;
use reference::{Q31, Q32, Subject, subjects};
use std::f64::consts::TAU;

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

/// Largest error allowed to each operation, in units of the last place of what it returns: Q31 for directions,
/// Q32 for all else. [warp, warp_sf, unit, unwarp, density, pdf, cdf, sf, quantile, isf], as in the docs.
const BOUNDS: [(&str, [f64; 10]); 6] = [
    ("Disk", [3.5, 3.5, 2.0, 5.0, 2.0, 4.5, 1.5, 1.5, 1.75, 1.75]),
    (
        "CircleShell",
        [2.0, 2.0, 2.0, 1.0, 0.0, 1.5, 1.5, 1.5, 2.0, 2.0],
    ),
    (
        "CircleArc",
        [2.0, 2.0, 2.0, 3.0, 0.5, 0.5, 0.0, 0.0, 1.0, 1.0],
    ),
    ("Ball", [2.5, 2.5, 2.5, 5.0, 3.0, 4.5, 7.0, 7.0, 2.5, 2.5]),
    (
        "SphereShell",
        [3.5, 3.5, 3.5, 4.0, 2.0, 4.0, 6.0, 6.0, 2.5, 2.5],
    ),
    (
        "Lambert",
        [1.0, 1.0, 1.5, 3.0, 1.5, 3.0, 5.0, 5.0, 2.0, 2.0],
    ),
];

fn hold(rows: &[usize], stride: usize) {
    let mut exceeding = Vec::new();
    for (law, (name, bounds)) in subjects().iter().zip(BOUNDS) {
        assert_eq!(law.name, name);
        for &row in rows {
            let ((operation, error), bound) = (ROWS[row], bounds[row]);
            let Worst(error, at) = worst(stride, |x| error(law, x));
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
#[ignore = "2³² words for each law: cargo test --release --features fixed --test fixed -- --ignored --nocapture"]
fn warps_exhaustively() {
    hold(&[0], 1);
}

#[test]
#[ignore = "2²⁶ words for each law and operation: cargo test --release --features fixed --test fixed -- --ignored --nocapture"]
fn laws_in_fine_strides() {
    hold(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9], 61);
}

/// (k, largest error of [warp, warp_sf, unit, quantile, cdf, sf, pdf, density]); the last two in units of 2⁻¹⁶.
///
/// cdf and density grow with k: an angle or a pair rounded to its format is off by that much.
const POWERS: [(f64, [f64; 8]); 10] = [
    (0.0, [2.5, 2.5, 2.0, 2.0, 5.0, 5.0, 1.0, 0.5]),
    (1.0 / 65536.0, [2.5, 2.5, 2.0, 2.0, 5.0, 5.0, 1.01, 1.01]),
    (0.5, [2.5, 2.5, 2.0, 2.0, 5.0, 5.0, 1.01, 1.01]),
    (1.0, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (2.0, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (3.0, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (7.25, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (64.0, [2.5, 2.5, 2.0, 2.0, 8.0, 8.0, 1.01, 1.01]),
    (1000.0, [2.5, 2.5, 2.0, 2.0, 24.0, 24.0, 1.1, 1.1]),
    (
        65536.0 - 1.0 / 65536.0,
        [2.5, 2.5, 2.0, 2.0, 180.0, 180.0, 1.5, 30.0],
    ),
];

/// ln cos of an angle in turns, from the sine where the cosine has lost it.
fn ln_cos(turn: f64) -> f64 {
    let (sin, cos) = (turn * TAU).sin_cos();
    if sin < 0.7 {
        0.5 * (-sin * sin).ln_1p()
    } else {
        cos.ln()
    }
}

#[test]
fn cos_power_in_strides() {
    for (k, bounds) in POWERS {
        let law = Fixed(coslobe::fixed::CosPower::new(U16F16::from_num(k)));
        let n = k + 1.0;
        let pair = |lower: f64, upper: f64| {
            let log = if upper > 0.5 {
                (-lower).ln_1p()
            } else {
                upper.ln()
            } / n;
            let square = if upper == 0.0 {
                1.0
            } else {
                -(2.0 * log).exp_m1()
            };
            (log.exp(), square.sqrt())
        };
        // θ of the first quadrant.
        let theta = |x: u32| (I0F32::from_bits((x >> 2) as i32), f64::from(x >> 2) / Q32);
        let off_wide = |got: U16F16, want: f64| (f64::from(got.to_bits()) - want * 65536.0).abs();
        let rows: [(&str, &(dyn Fn(u32) -> f64 + Sync)); 8] = [
            ("warp", &|u| {
                let (lower, upper) = tails(u);
                pair_off(law.warp(U0F32::from_bits(u)), pair(lower, upper))
            }),
            ("warp_sf", &|q| {
                let (upper, lower) = tails(q);
                pair_off(law.warp_sf(U0F32::from_bits(q)), pair(lower, upper))
            }),
            ("unit", &|u| {
                let at = law.warp(U0F32::from_bits(u));
                (f64::from(at.cos.to_bits()).hypot(f64::from(at.sin.to_bits())) - Q31).abs()
            }),
            ("quantile", &|u| {
                let (lower, upper) = tails(u);
                let (cos, sin) = pair(lower, upper);
                turn_off(law.quantile(U0F32::from_bits(u)), sin.atan2(cos) / TAU)
            }),
            ("cdf", &|x| {
                let (bits, turn) = theta(x);
                off(law.cdf(bits), -(n * ln_cos(turn)).exp_m1())
            }),
            ("sf", &|x| {
                let (bits, turn) = theta(x);
                off(law.sf(bits), (n * ln_cos(turn)).exp())
            }),
            ("pdf", &|x| {
                let (bits, turn) = theta(x);
                let lobe = n / TAU * (k * ln_cos(turn)).exp();
                off_wide(law.pdf(bits), lobe * (turn * TAU).sin())
            }),
            ("density", &|x| {
                let (_, turn) = theta(x);
                let (sin, cos) = (turn * TAU).sin_cos();
                let of = |x: f64| I1F31::from_bits((x * Q31).round().min(Q31 - 1.0) as i32);
                let at = CosSin {
                    cos: of(cos),
                    sin: of(sin),
                };
                off_wide(law.density(at), n / TAU * (k * ln_cos(turn)).exp())
            }),
        ];
        for ((operation, error), bound) in rows.into_iter().zip(bounds) {
            let Worst(error, at) = worst(40009, error);
            println!("CosPower({k}) {operation}: {error:.3} at {at:#010x} (bound {bound})");
            assert!(
                error <= bound,
                "CosPower({k}) {operation}: {error} at {at:#010x}"
            );
        }
    }
}

/// Corners of two arguments: any pair of words, unit vector or not, has tails and densities.
#[test]
fn any_pair_is_safe() {
    let words = [
        0,
        1,
        2,
        0x3FFF_FFFF,
        0x5A82_7999,
        0x5A82_799A,
        i32::MAX - 1,
        i32::MAX,
        i32::MIN,
        i32::MIN + 1,
        -1,
        -0x5A82_799A,
    ];
    let laws = [0u32, 1, 1 << 16, 64 << 16, u32::MAX]
        .map(|k| Fixed(coslobe::fixed::CosPower::new(U16F16::from_bits(k))));
    let scattered = (1..400u32).map(|i| i.wrapping_mul(0x9E37_79B9) as i32);
    let words: Vec<_> = words
        .into_iter()
        .chain(scattered)
        .map(I1F31::from_bits)
        .collect();
    for &cos in &words {
        for &sin in &words {
            let at = CosSin { cos, sin };
            for law in subjects() {
                let inside = cos > 0 && (law.planar || sin >= 0);
                // cos θ = 0 has a density for the uniform arc alone.
                let open = inside || (law.name == "CircleArc" && cos == 0);
                assert_eq!((law.density)(at) > 0, open, "{} at {at:?}", law.name);
                let (lower, upper) = ((law.unwarp)(at), (law.unwarp_sf)(at));
                assert!(lower > 0 || upper > 0, "{} at {at:?}", law.name);
            }
            for law in laws {
                assert_eq!(
                    law.density(at) > 0,
                    cos > 0 && sin >= 0,
                    "{law:?} at {at:?}"
                );
                assert!(
                    law.unwarp(at) > 0 || law.unwarp_sf(at) > 0,
                    "{law:?} at {at:?}"
                );
            }
        }
    }
}

/// Outside the support the densities are 0 and the tails 0 or 1, which saturates.
#[test]
fn outside_the_support() {
    for law in subjects() {
        for turn in [(1 << 30) + 1, i32::MAX, i32::MIN, -(1 << 30) - 1, -1] {
            if law.planar && turn == -1 {
                continue;
            }
            assert_eq!((law.pdf)(turn), U0F32::ZERO, "{} at {turn}", law.name);
            let (below, above) = (U0F32::ZERO, U0F32::MAX);
            let want = if turn < 0 {
                (below, above)
            } else {
                (above, below)
            };
            assert_eq!(
                ((law.cdf)(turn), (law.sf)(turn)),
                want,
                "{} at {turn}",
                law.name
            );
        }
    }
}

/// A spoiled law: the exponent of Lambert for SphereShell's, a root taken of a rounded number, a tail that is cut.
#[test]
fn wrong_laws_are_caught() {
    let subjects = subjects();
    let find = |name: &str| *subjects.iter().find(|law| law.name == name).expect("a law");
    let (shell, lambert, ball) = (find("SphereShell"), find("Lambert"), find("Ball"));
    let caught = |law: Subject, row: usize| {
        let (operation, error) = ROWS[row];
        let Worst(error, at) = worst(4093, |x| error(&law, x));
        println!("{operation}: {error:.1} at {at:#010x}");
        error > 8.0
    };
    assert!(caught(
        Subject {
            warp: lambert.warp,
            ..shell
        },
        0
    ));
    assert!(caught(
        Subject {
            quantile: lambert.quantile,
            ..shell
        },
        8
    ));
    assert!(caught(
        Subject {
            density: lambert.density,
            ..shell
        },
        4
    ));
    assert!(caught(
        Subject {
            cdf: lambert.cdf,
            ..shell
        },
        6
    ));
    // cos θ below 2⁻⁷ as 2⁻⁷.
    let cut: fn(u32) -> CosSin<I1F31> = |u| {
        let at = Fixed(coslobe::Ball).warp(U0F32::from_bits(u));
        CosSin {
            cos: at.cos.max(I1F31::from_bits(1 << 24)),
            ..at
        }
    };
    assert!(caught(Subject { warp: cut, ..ball }, 0));
    // sin θ as √(1 − cos²θ), which collapses beside the axis.
    let collapsed: fn(u32) -> CosSin<I1F31> = |u| {
        let at = Fixed(coslobe::Ball).warp(U0F32::from_bits(u));
        let cos = f64::from(at.cos.to_bits()) / Q31;
        CosSin {
            sin: I1F31::from_bits(((1.0 - cos * cos).sqrt() * Q31) as i32),
            ..at
        }
    };
    assert!(caught(
        Subject {
            warp: collapsed,
            ..ball
        },
        0
    ));
}
