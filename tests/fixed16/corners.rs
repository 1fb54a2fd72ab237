//! Any pair, both ends, order, and wrong laws, which must be caught.

use crate::subject::{Pair, Subject, subjects};
use crate::{PAIRS, Q15, WORDS, Worst, pair, unit_pairs};
use coslobe::{Ball, CosSin, Fixed16, Lambert};
use fixed::types::{I1F15, U0F16};
use rayon::prelude::*;

/// Every `stride`th pair of words, unit vector or not, has tails and densities.
fn any_pair_is_safe(stride: u32) {
    let laws = subjects();
    (0..=u32::MAX / stride).into_par_iter().for_each(|i| {
        let at = pair(i * stride);
        for law in laws {
            let inside = at.cos > 0 && (law.planar || at.sin >= 0);
            // cos θ = 0 has a density for the uniform arc alone.
            let open = inside || (law.name == "CircleArc" && at.cos == 0);
            assert_eq!((law.density)(at) > 0, open, "{} at {at:?}", law.name);
            let (lower, upper) = ((law.unwarp)(at), (law.unwarp_sf)(at));
            assert!(lower > 0 || upper > 0, "{} at {at:?}", law.name);
        }
    });
}

#[test]
fn pairs_in_strides() {
    any_pair_is_safe(251);
}

#[test]
#[ignore = "2³² pairs: cargo test --features fixed --test fixed16 -- --ignored"]
fn every_pair() {
    any_pair_is_safe(1);
}

/// Words in which a carry or a sign may go wrong, all against all.
#[test]
fn pairs_of_corners() {
    let words = [0, 1, 2, 0x3FFF, 0x5A81, 0x5A82, 0x5A83, 0x7FFE, 0x7FFF];
    let words: Vec<u32> = words
        .into_iter()
        .flat_map(|x: u16| [x, x.wrapping_neg(), !x])
        .map(u32::from)
        .collect();
    for &cos in &words {
        for &sin in &words {
            let at = pair((cos << 16) | sin);
            for law in subjects() {
                let sum = u32::from((law.unwarp)(at)) + u32::from((law.unwarp_sf)(at));
                assert!(sum.abs_diff(1 << 16) <= 4, "{} at {at:?}: {sum}", law.name);
            }
        }
    }
}

/// Outside the support the densities are 0 and the tails 0 or 1, which saturates; at its ends all are exact.
#[test]
fn ends_of_the_support() {
    for law in subjects() {
        let least: i16 = if law.planar { -0x4000 } else { 0 };
        for turn in i16::MIN..=i16::MAX {
            let want = match turn {
                _ if turn < least => (0, u16::MAX),
                _ if turn > 0x4000 => (u16::MAX, 0),
                _ => continue,
            };
            assert_eq!((law.pdf)(turn), 0, "{} at {turn}", law.name);
            let found = ((law.cdf)(turn), (law.sf)(turn));
            assert_eq!(found, want, "{} at {turn}", law.name);
        }
        let ends = ((law.quantile)(0), (law.isf)(0));
        assert_eq!(ends, (least, 0x4000), "{}", law.name);
        let ends = ((law.sf)(least), (law.cdf)(0x4000));
        println!("{} {ends:?}", law.name);
        assert!(ends.0 >= u16::MAX - 2 && ends.1 == u16::MAX, "{}", law.name);
    }
}

/// Largest step back of each operation, in units, where its word has one more than the last.
fn steps_back(law: &Subject) -> [i32; 4] {
    let back = |of: &dyn Fn(u16) -> i32| {
        let steps = (0..u16::MAX).map(|x| of(x) - of(x + 1));
        steps.max().unwrap_or(i32::MAX)
    };
    let turn = |x: u16| (x ^ 0x8000) as i16;
    [
        back(&|p| (law.quantile)(p).into()),
        back(&|p| -i32::from((law.isf)(p))),
        back(&|x| (law.cdf)(turn(x)).into()),
        back(&|x| -i32::from((law.sf)(turn(x)))),
    ]
}

/// The order is kept but for one unit here and there.
const STEPS_BACK: [(&str, [i32; 4]); 6] = [
    ("Disk", [0, 0, 1, 1]),
    ("CircleShell", [0, 0, 0, 0]),
    ("CircleArc", [0, 0, 0, 0]),
    ("Ball", [1, 1, 1, 0]),
    ("SphereShell", [1, 1, 0, 0]),
    ("Lambert", [0, 0, 0, 0]),
];

#[test]
fn order_is_kept() {
    for (law, (name, most)) in subjects().iter().zip(STEPS_BACK) {
        assert_eq!((law.name, steps_back(law)), (name, most));
    }
    let [_, _, _, _, _, lambert] = subjects();
    let quantile: fn(u16) -> i16 = |p| {
        let q = Fixed16(Lambert).quantile(U0F16::from_bits(p)).to_bits();
        if p == 0x1234 { q - 2 } else { q }
    };
    let spoiled = Subject {
        quantile,
        ..lambert
    };
    assert_ne!(steps_back(&spoiled), STEPS_BACK[5].1);
}

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

/// Spoiled laws: the exponent of another, an arc for a shell, a tail that is cut, a sine that collapses.
#[test]
fn wrong_laws_are_caught() {
    let [_, chord, arc, ball, shell, lambert] = subjects();
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
