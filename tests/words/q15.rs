//! Each sample against the closed form of the words that it took, which pins what is documented of
//! them.

use coslobe::integers::Fixed16Law;
use coslobe::rand_core::Rng;
use coslobe::{Ball, CircleArc, CircleShell, Disk, Fixed16, Lambert, SphereShell};
use fixed::types::I1F15;
use kit::Id;
use kit::integer::short::Q15;
use kit::integer::truth::Truth;
use kit::stats::words::{self, Words};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

const Q32: f64 = 4294967296.0;
const N: usize = 1_000_000;

/// The largest of N half-words, continued with the exclusive or of the others.
fn largest(halves: &[u32]) -> f64 {
    let largest = *halves.iter().max().expect("half-words");
    let others = halves.iter().fold(largest, |all, half| all ^ half);
    f64::from((largest << 16) | others) / Q32
}

fn halves(word: u32) -> [u32; 2] {
    [word >> 16, word & 0xFFFF]
}

fn spatial(cos: f64, phase: u32) -> [f64; 3] {
    let sin = (1.0 - cos * cos).sqrt();
    let y = f64::from((phase >> 13) & 0xFFFF) / 65536.0;
    let (s, c) = (y * FRAC_PI_4).sin_cos();
    let (x, z) = if phase >> 29 & 1 == 0 { (c, s) } else { (s, c) };
    let along = |part: f64, bit: u32| if phase >> bit & 1 == 0 { part } else { -part };
    [sin * along(x, 30), cos, sin * along(z, 31)]
}

fn planar(cos: f64, sin: f64, negative: u32) -> [f64; 3] {
    [if negative & 1 == 0 { sin } else { -sin }, cos, 0.0]
}

fn lambert([a, b]: [u32; 2]) -> [f64; 3] {
    spatial(largest(&halves(a)), b)
}

fn sphere_shell([a, b]: [u32; 2]) -> [f64; 3] {
    let [azimuth, third] = halves(b);
    let [first, second] = halves(a);
    spatial(largest(&[first, second, third]), (azimuth << 16) | 0x8000)
}

fn ball([a, b, c]: [u32; 3]) -> [f64; 3] {
    let ([d, e], [f, g]) = (halves(a), halves(b));
    spatial(largest(&[d, e, f, g]), c)
}

fn disk([a, b]: [u32; 2]) -> [f64; 3] {
    let [spare, third] = halves(b);
    let [first, second] = halves(a);
    let p = largest(&[first, second, third]).powi(3) / 2.0;
    let (cos, sin) = Truth::of(Id::Disk).pair(1.0 - p, p);
    planar(cos, sin, spare >> 15)
}

fn circle_shell([a]: [u32; 1]) -> [f64; 3] {
    let v = f64::from((a << 1) | 1) / Q32;
    planar((v * (2.0 - v)).sqrt(), 1.0 - v, a >> 31)
}

fn circle_arc([a]: [u32; 1]) -> [f64; 3] {
    let (sin, cos) = (f64::from((a << 1) | 1) / Q32 * FRAC_PI_2).sin_cos();
    planar(cos, sin, a >> 31)
}

/// [largest error of a component, of the length], in units.
fn errors<L: Fixed16Law, const W: usize>(law: L, of: fn([u32; W]) -> [f64; 3]) -> [f64; 2]
where
    L::Direction: AsRef<[I1F15]>,
{
    let mut rng = words::pcg("maps");
    let corners = [
        0,
        1,
        0xFFFF,
        0x1_0000,
        0x7FFF_FFFF,
        0x8000_0000,
        0xFFFE_FFFF,
        0xFFFF_0000,
        0xFFFF_FFFE,
        u32::MAX,
    ];
    let mut worst = [0.0f64; 2];
    for i in 0..N {
        let words: [u32; W] = std::array::from_fn(|j| {
            // Every corner against every other, then anything.
            let corner = corners.get(i / corners.len().pow(j as u32) % corners.len());
            let word = rng.next_u32();
            if i < 1000 {
                corner.map_or(word, |&c| c)
            } else {
                word
            }
        });
        let mut next = words.iter();
        let mut source =
            Words::new(|| u64::from(*next.next().expect("no more words than documented")));
        let direction = Fixed16(law).sample(&mut source);
        assert_eq!(source.drawn, (W, 0));
        let mut found = [0.0; 3];
        for (to, from) in found.iter_mut().zip(direction.as_ref()) {
            *to = f64::from(*from) * Q15;
        }
        let off = of(words).map(|x| x * Q15);
        let off = (0..3)
            .map(|j| (found[j] - off[j]).abs())
            .fold(0.0, f64::max);
        let length = found.iter().map(|x| x * x).sum::<f64>().sqrt();
        worst = [worst[0].max(off), worst[1].max((length - Q15).abs())];
    }
    worst
}

#[test]
fn samples_are_functions_of_their_words() {
    let found = [
        ("Lambert", errors(Lambert, lambert), [1.27, 1.5]),
        (
            "SphereShell",
            errors(SphereShell, sphere_shell),
            [1.22, 1.44],
        ),
        ("Ball", errors(Ball, ball), [1.22, 1.39]),
        ("Disk", errors(Disk, disk), [1.7, 1.04]),
        ("CircleShell", errors(CircleShell, circle_shell), [1.0, 1.0]),
        ("CircleArc", errors(CircleArc, circle_arc), [1.21, 1.04]),
    ];
    for (name, errors, bounds) in found {
        println!(
            "{name}: component {:.3}, length {:.3} (bounds {bounds:?})",
            errors[0], errors[1]
        );
        assert!(
            errors[0] <= bounds[0] && errors[1] <= bounds[1],
            "{name}: {errors:?}"
        );
    }
}

#[test]
fn another_map_is_caught() {
    // The third half-word is another's; a root in place of a maximum; an arc for a shell.
    assert!(errors(SphereShell, |[a, b]| sphere_shell([a, b.rotate_left(16)]))[0] > 100.0);
    assert!(errors(Lambert, |[a, b]| spatial((f64::from(a) / Q32).sqrt(), b))[0] > 100.0);
    assert!(errors(CircleShell, circle_arc)[0] > 100.0);
}
