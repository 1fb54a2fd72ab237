//! χ², Kolmogorov–Smirnov, moments and tails of the samplers in integers; wrong ones, which must
//! fail them; and generators that are stuck.

use crate::drawn::{Draws, N};
use coslobe::integers::CosPower;
use coslobe::rand_core::Rng;
use coslobe::{Ball, CircleArc, CosSin, Fixed, Lambert};
use fixed::types::{I0F32, U0F32, U16F16};
use kit::Id;
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law, moments};
use kit::integer::{Format, Long, Short, direction};
use kit::stats::claim::{Claim, Direction};
use kit::stats::harness::{examine, examine_tail};
use kit::stats::ks;
use kit::stats::words::{self, Words};

fn claim<F: Format>(id: Id) -> Claim {
    let moments = moments::<f64>(id).expect("an exponent");
    F::claim(&id.to_string(), id.planar(), id.exponent(), moments)
}

struct Laws;

impl Laws {
    fn of<F: Draws, L: IntegerLaw>(law: L) {
        let claim = claim::<F>(L::ID);
        let drawn = F::of(L::ID);
        let mut rng = words::pcg(&claim.name);
        examine(&claim, drawn.samples, || F::sample(law, &mut rng)).accepted();
        let draw = |rng: &mut dyn Rng| F::sample(law, rng);
        let report = examine_tail(&claim, drawn.depth, F::TAIL_SAMPLES, drawn.shape, draw);
        // A small maximum is a tail of one side alone: the horizon of a law in space.
        let report = if claim.planar {
            report
        } else {
            report.without("side")
        };
        report.accepted();
    }
}

impl IntegerVisitor for Laws {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        Self::of::<Long, L>(law);
        Self::of::<Short, L>(law);
    }
}

fn power(k: f64) -> Fixed<CosPower> {
    Fixed(CosPower::new(U16F16::from_num(k)))
}

#[test]
fn laws() {
    every_integer_law(&mut Laws);
    for k in [0.0, 0.5, 7.25, 200.0, 10_000.0] {
        let claim = claim::<Long>(Id::CosPower(k));
        let mut rng = words::pcg(&claim.name);
        examine(&claim, N, || direction(&power(k).sample(&mut rng))).accepted();
    }
}

fn rejected(claim: Claim, n: usize, draw: impl Fn(&mut dyn Rng) -> Direction, test: &str) {
    let mut rng = words::pcg("mutant");
    assert!(
        examine(&claim, n, || draw(&mut rng)).rejects(test),
        "{test}"
    );
}

fn wrong_laws<F: Format>() {
    rejected(
        claim::<F>(Id::Ball),
        20_000,
        |rng| F::sample(Lambert, rng),
        "KS theta",
    );
    rejected(
        claim::<F>(Id::CircleShell),
        20_000,
        |rng| F::sample(CircleArc, rng),
        "KS theta",
    );
    let space = claim::<F>(Id::Lambert);
    let near = F::claim("k = 1.1", false, 1.1, space.moments);
    rejected(near, 100_000, |rng| F::sample(Lambert, rng), "KS theta");
}

#[test]
fn wrong_laws_are_rejected() {
    wrong_laws::<Long>();
    wrong_laws::<Short>();
    // A uniform of 24 bits has no direction nearer to the horizon than its last step.
    let cut = |rng: &mut dyn Rng| {
        let at = Fixed(Ball).warp_sf(U0F32::from_bits(rng.next_u32() & !0xFF | 0x80));
        let azimuth: CosSin<_> =
            coslobe::integers::cos_sin(I0F32::from_bits(rng.next_u32() as i32));
        let [cos, sin, x, z] = [at.cos, at.sin, azimuth.cos, azimuth.sin].map(f64::from);
        [sin * x, cos, sin * z]
    };
    rejected(claim::<Long>(Id::Ball), N, cut, "ties");
    // Half-words of 8 bits.
    let bytes = |rng: &mut dyn Rng| {
        let mut bytes = Words::new(|| u64::from(rng.next_u32() & 0xFF00_FF00));
        Short::sample(Ball, &mut bytes)
    };
    rejected(claim::<Short>(Id::Ball), 100_000, bytes, "ties");
}

/// sin²θ beside the axis, as a share of what one unit of cos θ in Q16 spans.
fn shares<L: IntegerLaw>(law: L, shape: fn(usize, u32) -> u32) -> Vec<f64> {
    let mut rng = words::pcg("axis");
    let mut share = || {
        let mut i = 0;
        let mut shaped = Words::new(|| {
            i += 1;
            u64::from(shape(i, rng.next_u32()))
        });
        let [x, _, z] = Short::sample(law, &mut shaped);
        (x * x + z * z) * 32768.0
    };
    (0..10_000).map(|_| share()).collect()
}

/// Where the maximum is the greatest half-word, the others' bits go on.
#[test]
fn sines_have_no_grid_beside_the_axis() {
    struct Axis;
    impl IntegerVisitor for Axis {
        fn law<L: IntegerLaw>(&mut self, law: L) {
            if L::ID.planar() {
                return;
            }
            let axis = |i, word| if i == 1 { word | 0xFFFF_0000 } else { word };
            let p = ks::uniform(&mut shares(law, axis));
            assert!(p > 1e-4, "{}: {p}", L::ID);
        }
    }
    every_integer_law(&mut Axis);
    let cut = |i, word| if i == 1 { 0xFFFF_0000 } else { word };
    assert!(ks::uniform(&mut shares(Lambert, cut)) < 1e-9);
}

/// Directions of hostile generators.
fn open(name: &str, words: usize, length: f64, draw: impl Fn(&mut dyn Rng) -> Direction) {
    for (generator, mut source) in words::hostile() {
        let mut rng = Words::new(&mut source);
        for _ in 0..64 {
            let before = rng.drawn;
            let [x, y, z] = draw(&mut rng);
            let drawn = (rng.drawn.0 - before.0, rng.drawn.1 - before.1);
            assert_eq!(drawn, (words, 0), "{name}: words drawn");
            let off = ((x * x + y * y + z * z).sqrt() - 1.0).abs();
            assert!(off <= length, "{name}, {generator}: length off by {off}");
            assert!(y > 0.0 && y < 1.0, "{name}, {generator}: cos θ = {y}");
        }
    }
}

#[test]
fn stuck_generators_give_directions_inside_the_support() {
    struct Open;
    impl Open {
        fn of<F: Draws, L: IntegerLaw>(law: L) {
            let name = claim::<F>(L::ID).name;
            open(&name, F::of(L::ID).words, F::LENGTH, |rng| {
                F::sample(law, rng)
            });
        }
    }
    impl IntegerVisitor for Open {
        fn law<L: IntegerLaw>(&mut self, law: L) {
            Self::of::<Long, L>(law);
            Self::of::<Short, L>(law);
        }
    }
    every_integer_law(&mut Open);
    for k in [U16F16::ZERO, U16F16::ONE, U16F16::from_num(64), U16F16::MAX] {
        let law = Fixed(CosPower::new(k));
        open("CosPower", 3, Long::LENGTH, |rng| {
            direction(&law.sample(rng))
        });
    }
}
