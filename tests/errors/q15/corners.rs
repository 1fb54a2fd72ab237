//! Any pair, both ends, and order.

use super::pairs::pair;
use coslobe::{Fixed16, Lambert};
use fixed::types::U0F16;
use kit::integer::short::{Subject, subjects};
use rayon::prelude::*;

/// Every `stride`th pair of words, unit vector or not, has tails and densities.
fn any_pair_is_safe(stride: u32) {
    let laws = subjects();
    (0..=u32::MAX / stride).into_par_iter().for_each(|i| {
        let at = pair(i * stride);
        for law in &laws {
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
#[ignore = "2³² pairs: cargo test --test errors q15 -- --ignored"]
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

/// Outside the support the densities are 0 and the tails 0 or 1, which saturates; at its ends all
/// are exact.
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
    let lambert = subjects()[5];
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
