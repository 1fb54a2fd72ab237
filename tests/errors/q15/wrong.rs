//! Wrong laws, which the exhaustive errors must catch.

use super::pairs::unit_pairs;
use super::{PAIRS, WORDS, Worst};
use coslobe::{Ball, CosSin, Fixed16};
use fixed::types::{I1F15, U0F16};
use kit::integer::short::Q15;
use kit::integer::short::{Pair, Subject, subjects};

fn caught(law: Subject, row: &str) -> bool {
    let words = WORDS.iter().find(|(name, _)| *name == row);
    let worst = match words {
        Some((_, error)) => Worst::over(0..1 << 16, |x| error(&law, x)),
        None => {
            let (_, error) = PAIRS.iter().find(|(name, _)| *name == row).expect("a row");
            Worst::over(unit_pairs(law.planar).into_iter(), |x| error(&law, x))
        }
    };
    println!("{} {row}: {:.1} at {:#06x}", law.name, worst.0, worst.1);
    worst.0 > 8.0
}

/// Spoiled laws: the exponent of another, an arc for a shell, a tail that is cut, a sine that
/// collapses.
#[test]
fn wrong_laws_are_caught() {
    let [_, chord, arc, ball, shell, lambert] = subjects()[..] else {
        panic!("six laws");
    };
    assert!(caught(
        Subject {
            warp: lambert.warp,
            ..shell
        },
        "warp"
    ));
    assert!(caught(
        Subject {
            warp_sf: arc.warp_sf,
            ..chord
        },
        "warp_sf"
    ));
    assert!(caught(
        Subject {
            quantile: arc.quantile,
            ..chord
        },
        "quantile"
    ));
    assert!(caught(
        Subject {
            isf: lambert.isf,
            ..shell
        },
        "isf"
    ));
    assert!(caught(
        Subject {
            density: shell.density,
            ..ball
        },
        "density"
    ));
    assert!(caught(
        Subject {
            pdf: arc.pdf,
            ..chord
        },
        "pdf"
    ));
    assert!(caught(
        Subject {
            cdf: shell.cdf,
            ..ball
        },
        "cdf"
    ));
    assert!(caught(
        Subject {
            sf: arc.sf,
            ..chord
        },
        "sf"
    ));
    assert!(caught(
        Subject {
            unwarp: lambert.unwarp,
            ..shell
        },
        "unwarp"
    ));
    // cos θ below 2⁻⁷ as 2⁻⁷.
    let cut: fn(u16) -> Pair = |q| {
        let at = Fixed16(Ball).warp_sf(U0F16::from_bits(q));
        CosSin {
            cos: at.cos.max(I1F15::from_bits(1 << 8)),
            ..at
        }
    };
    assert!(caught(
        Subject {
            warp_sf: cut,
            ..ball
        },
        "warp_sf"
    ));
    // sin θ as √(1 − cos²θ), which collapses beside the axis.
    let collapsed: fn(u16) -> Pair = |u| {
        let at = Fixed16(Ball).warp(U0F16::from_bits(u));
        let cos = f64::from(at.cos);
        CosSin {
            sin: I1F15::from_bits(((1.0 - cos * cos).sqrt() * Q15) as i16),
            ..at
        }
    };
    assert!(caught(
        Subject {
            warp: collapsed,
            ..ball
        },
        "warp"
    ));
    // Too long by a few units.
    let long: fn(u16) -> Pair = |u| {
        let at = Fixed16(Ball).warp(U0F16::from_bits(u));
        CosSin {
            cos: at.cos.saturating_add(I1F15::from_bits(12)),
            ..at
        }
    };
    assert!(caught(Subject { warp: long, ..ball }, "unit"));
}
