//! Any pair, angles outside the support, and wrong laws, which must be caught.

use super::{ROWS, Worst, worst};
use coslobe::{CosSin, Fixed};
use fixed::types::{I1F31, U0F32, U16F16};
use kit::integer::reference::{Q31, Subject, subjects};

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
        .map(|k| Fixed(coslobe::integers::CosPower::new(U16F16::from_bits(k))));
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
                // Of the powers k = 0 has one.
                let rim = cos == 0 && law.0.exponent() == 0;
                let open = (cos > 0 || rim) && sin >= 0;
                assert_eq!(law.density(at) > 0, open, "{law:?} at {at:?}");
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

/// A spoiled law: the exponent of Lambert for Ball's, a root taken of a rounded number, a tail that
/// is cut.
#[test]
fn wrong_laws_are_caught() {
    let subjects = subjects();
    let find = |name: &str| *subjects.iter().find(|law| law.name == name).expect("a law");
    let (lambert, ball) = (find("Lambert"), find("Ball"));
    let caught = |law: Subject, row: usize| {
        let (operation, error) = ROWS[row];
        let Worst(error, at) = worst(4093, |x| error(&law, x));
        println!("{operation}: {error:.1} at {at:#010x}");
        error > 8.0
    };
    assert!(caught(
        Subject {
            warp: lambert.warp,
            ..ball
        },
        0
    ));
    assert!(caught(
        Subject {
            quantile: lambert.quantile,
            ..ball
        },
        8
    ));
    assert!(caught(
        Subject {
            density: lambert.density,
            ..ball
        },
        4
    ));
    assert!(caught(
        Subject {
            cdf: lambert.cdf,
            ..ball
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
