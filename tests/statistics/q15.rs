//! χ², Kolmogorov–Smirnov, moments and tails of the 16-bit samplers; wrong ones, which must fail them; and generators
//! that are stuck.

use coslobe::integers::Fixed16Law;
use coslobe::rand_core::Rng;
use coslobe::{Ball, CircleArc, CircleShell, Disk, Fixed16, Lambert, Law, Moments, SphereShell};
use fixed::types::I1F15;
use kit::integer::short::Q15;
use kit::stats::claim::{Claim, Direction};
use kit::stats::harness::{examine, examine_tail};
use kit::stats::ks;
use kit::stats::words::{self, Words};

/// One unit in the last place.
const UNIT: f64 = 1.0 / Q15;
const N: usize = 1_000_000;
const TAIL_N: usize = 20_000;

trait Drawn: Fixed16Law<Direction: AsRef<[I1F15]>> {
    fn direction<R: Rng + ?Sized>(self, rng: &mut R) -> Direction {
        let drawn = Fixed16(self).sample(rng);
        let mut direction = [0.0; 3];
        for (to, from) in direction.iter_mut().zip(drawn.as_ref()) {
            *to = (*from).into();
        }
        direction
    }
}

impl<L: Fixed16Law<Direction: AsRef<[I1F15]>>> Drawn for L {}

fn claim(name: &str, planar: bool, k: f64, moments: Moments<f64>) -> Claim {
    Claim {
        name: format!("Fixed16({name})"),
        planar,
        k,
        moments,
        epsilon: UNIT,
        length: 2.0 * UNIT,
        error: 2.0 * UNIT,
        // Cosines are UNIT apart, not relatively so: of two tails below 1/256 as many are equal as if relatively this.
        grid: if k == 0.0 { 128.0 } else { 16.0 } * UNIT,
    }
}

/// Draws `n`, then as many as matter with words shaped into the tail below 2^−`depth`.
fn check<L: Drawn>(law: L, claim: &Claim, n: usize, depth: u32, shape: fn(u32, u64) -> u64) {
    let mut rng = words::pcg(&claim.name);
    examine(claim, n, || law.direction(&mut rng)).accepted();
    let report = examine_tail(claim, depth, TAIL_N, shape, |rng| law.direction(rng));
    // A small maximum is a tail of one side alone: the horizon of a law in space.
    let report = if claim.planar {
        report
    } else {
        report.without("side")
    };
    report.accepted();
}

/// Half-words below 2¹².
fn low(word: u64) -> u64 {
    word & 0x0FFF_0FFF
}

#[test]
fn laws() {
    let first = |i, word| if i == 0 { low(word) } else { word };
    let all = |i, word| if i < 2 { low(word) } else { word };
    // The second word's upper half is the azimuth or the sign.
    let three = |i, word| match i {
        0 => low(word),
        1 => word & 0xFFFF_0FFF,
        _ => word,
    };
    check(
        Lambert,
        &claim("Lambert", false, 1.0, Lambert.moments()),
        N,
        8,
        first,
    );
    check(
        SphereShell,
        &claim("SphereShell", false, 2.0, SphereShell.moments()),
        N,
        12,
        three,
    );
    check(Ball, &claim("Ball", false, 3.0, Ball.moments()), N, 16, all);
    check(
        Disk,
        &claim("Disk", true, 2.0, Disk.moments()),
        N,
        13,
        three,
    );
    let chord = claim("CircleShell", true, 1.0, CircleShell.moments());
    check(CircleShell, &chord, N, 11, |_, word| {
        (word & 0x8000_0000) | ((word & 0x7FFF_FFFF) >> 10)
    });
    // Of more samples the horizon's last unit would hold too many.
    let arc = claim("CircleArc", true, 0.0, CircleArc.moments());
    check(CircleArc, &arc, N / 10, 7, |_, word| word | 0x7E00_0000);
}

#[test]
fn wrong_laws_are_rejected() {
    let rejected = |claim: Claim, draw: fn(&mut dyn Rng) -> Direction, test: &str| {
        let mut rng = words::pcg("mutant");
        examine(&claim, 100_000, || draw(&mut rng)).rejects(test)
    };
    let shell = claim("Lambert as SphereShell", false, 2.0, SphereShell.moments());
    assert!(rejected(shell, |rng| Lambert.direction(rng), "KS theta"));
    let ball = claim("SphereShell as Ball", false, 3.0, Ball.moments());
    assert!(rejected(ball, |rng| SphereShell.direction(rng), "KS theta"));
    let chord = claim("arc for shell", true, 1.0, CircleShell.moments());
    assert!(rejected(chord, |rng| CircleArc.direction(rng), "KS theta"));
    // Half-words of 8 bits.
    let ball = claim("Ball of bytes", false, 3.0, Ball.moments());
    let bytes: fn(&mut dyn Rng) -> Direction =
        |rng| Ball.direction(&mut Words::new(|| u64::from(rng.next_u32() & 0xFF00_FF00)));
    assert!(rejected(ball, bytes, "ties"));
}

/// sin²θ beside the axis, as a share of what one unit of cos θ in Q16 spans.
fn shares<L: Drawn>(law: L, shape: fn(usize, u32) -> u32) -> Vec<f64> {
    let mut rng = words::pcg("axis");
    let mut share = || {
        let mut i = 0;
        let [x, _, z] = law.direction(&mut Words::new(|| {
            i += 1;
            u64::from(shape(i, rng.next_u32()))
        }));
        (x * x + z * z) * 32768.0
    };
    (0..10_000).map(|_| share()).collect()
}

/// Where the maximum is the greatest half-word, the others' bits go on.
#[test]
fn sines_have_no_grid_beside_the_axis() {
    let axis = |i, word| if i == 1 { word | 0xFFFF_0000 } else { word };
    for mut shares in [
        shares(Lambert, axis),
        shares(SphereShell, axis),
        shares(Ball, axis),
    ] {
        let p = ks::uniform(&mut shares);
        assert!(p > 1e-4, "{p}");
    }
    let cut = |i, word| if i == 1 { 0xFFFF_0000 } else { word };
    assert!(ks::uniform(&mut shares(Lambert, cut)) < 1e-9);
}

fn open<L: Drawn>(law: L, words: usize, name: &str) {
    for (generator, mut source) in words::hostile() {
        let mut rng = Words::new(&mut source);
        for _ in 0..64 {
            let before = rng.drawn;
            let [x, y, z] = law.direction(&mut rng);
            let drawn = (rng.drawn.0 - before.0, rng.drawn.1 - before.1);
            assert_eq!(drawn, (words, 0), "{name}: words drawn");
            let length = (x * x + y * y + z * z).sqrt();
            assert!(
                (length - 1.0).abs() <= 2.0 * UNIT,
                "{name}, {generator}: length {length}"
            );
            assert!(y > 0.0 && y < 1.0, "{name}, {generator}: cos θ = {y}");
        }
    }
}

#[test]
fn stuck_generators_give_directions_inside_the_support() {
    open(Lambert, 2, "Lambert");
    open(SphereShell, 2, "SphereShell");
    open(Ball, 3, "Ball");
    open(Disk, 2, "Disk");
    open(CircleShell, 1, "CircleShell");
    open(CircleArc, 1, "CircleArc");
}
