//! χ², Kolmogorov–Smirnov, moments and tails of the fixed-point samplers; wrong ones, which must fail them; and
//! generators that are stuck.

use coslobe::integers::{CosPower, FixedLaw};
use coslobe::rand_core::Rng;
use coslobe::{Ball, CircleArc, CircleShell, Disk, Fixed, Lambert, Law, Moments, SphereShell};
use fixed::types::{I1F31, U0F32, U16F16};
use kit::stats::claim::{Claim, Direction};
use kit::stats::harness::{examine, examine_tail};
use kit::stats::words::{self, Words};

/// One unit in the last place.
const UNIT: f64 = 1.0 / 2147483648.0;
const N: usize = 1_000_000;
const TAIL_N: usize = 50_000;

trait ToDirection {
    fn direction(self) -> Direction;
}

impl ToDirection for [I1F31; 2] {
    fn direction(self) -> Direction {
        [self[0].into(), self[1].into(), 0.0]
    }
}

impl ToDirection for [I1F31; 3] {
    fn direction(self) -> Direction {
        self.map(Into::into)
    }
}

fn claim(name: &str, planar: bool, k: f64, moments: Moments<f64>) -> Claim {
    Claim {
        name: format!("Fixed({name})"),
        planar,
        k,
        moments,
        epsilon: UNIT,
        length: 4.0 * UNIT,
        error: 4.0 * UNIT,
        // Cosines are UNIT apart, not relatively so: of two tails below 1/256 as many are equal as if relatively 2⁻²³.
        grid: 256.0 * UNIT,
    }
}

/// Shapes the i-th word so that its law's deep tail is met.
type Shape = fn(u32, u64) -> u64;

fn check<L: FixedLaw>(law: L, claim: &Claim, depth: u32, shape: Shape)
where
    L::Direction: ToDirection,
{
    let law = Fixed(law);
    let mut rng = words::pcg(&claim.name);
    examine(claim, N, || law.sample(&mut rng).direction()).accepted();
    let draw = |rng: &mut dyn Rng| law.sample(rng).direction();
    let report = examine_tail(claim, depth, TAIL_N, shape, draw);
    // A small maximum is a tail of one side alone: the horizon of a law in space.
    let report = if claim.planar {
        report
    } else {
        report.without("side")
    };
    report.accepted();
}

/// Of a maximum of n words below 2^(32−s) the probability is 2^−ns; of two words as one number, 2^−s.
#[test]
fn laws() {
    const SHIFTED: Shape = |i, word| {
        if i < 4 {
            u64::from(word as u32 >> 15)
        } else {
            word
        }
    };
    check(
        Lambert,
        &claim("Lambert", false, 1.0, Lambert.moments()),
        30,
        |i, word| {
            if i < 2 {
                u64::from(word as u32 >> 15)
            } else {
                word
            }
        },
    );
    check(
        SphereShell,
        &claim("SphereShell", false, 2.0, SphereShell.moments()),
        45,
        |i, word| {
            if i < 3 {
                u64::from(word as u32 >> 15)
            } else {
                word
            }
        },
    );
    check(
        Ball,
        &claim("Ball", false, 3.0, Ball.moments()),
        60,
        SHIFTED,
    );
    check(
        Disk,
        &claim("Disk", true, 2.0, Disk.moments()),
        46,
        |i, word| match i {
            // The top bit is the sign.
            0 => (word & 0x8000_0000) | ((word & 0x7FFF_FFFF) >> 15),
            _ => SHIFTED(i, word),
        },
    );
    check(
        CircleShell,
        &claim("CircleShell", true, 1.0, CircleShell.moments()),
        31,
        |i, word| {
            if i == 0 { word & 0x8000_0001 } else { word }
        },
    );
    check(
        CircleArc,
        &claim("CircleArc", true, 0.0, CircleArc.moments()),
        17,
        |_, word| word | 0x7FFF_8000,
    );
    for k in [0.0, 0.5, 7.25, 200.0, 10_000.0] {
        let moments = coslobe::CosPower::new(k)
            .expect("a finite exponent")
            .moments();
        let claim = claim(&format!("CosPower({k})"), false, k, moments);
        let mut rng = words::pcg(&claim.name);
        let law = Fixed(CosPower::new(U16F16::from_num(k)));
        examine(&claim, N, || law.sample(&mut rng).direction()).accepted();
    }
}

#[test]
fn a_wrong_exponent_is_rejected() {
    let shell = claim("Lambert as SphereShell", false, 2.0, SphereShell.moments());
    let mut rng = words::pcg("mutant");
    assert!(
        examine(&shell, 20_000, || Fixed(Lambert)
            .sample(&mut rng)
            .direction())
        .rejects("KS theta")
    );
    let ball = claim("SphereShell as Ball", false, 3.0, Ball.moments());
    assert!(
        examine(&ball, 20_000, || Fixed(SphereShell)
            .sample(&mut rng)
            .direction())
        .rejects("KS theta")
    );
}

/// A uniform of 24 bits has no direction nearer to the horizon than its last step.
#[test]
fn a_truncated_tail_is_rejected() {
    let ball = claim("Ball of 24 bits", false, 3.0, Ball.moments());
    let mut rng = words::pcg("mutant");
    let draw = || {
        let at = Fixed(Ball).warp_sf(U0F32::from_bits(rng.next_u32() & !0xFF | 0x80));
        let azimuth =
            coslobe::integers::cos_sin(fixed::types::I0F32::from_bits(rng.next_u32() as i32));
        let [cos, sin, x, z] = [at.cos, at.sin, azimuth.cos, azimuth.sin].map(f64::from);
        [sin * x, cos, sin * z]
    };
    assert!(examine(&ball, N, draw).rejects("ties"));
}

fn open<L: FixedLaw>(law: L, words: u32, name: &str)
where
    L::Direction: ToDirection,
{
    for (generator, mut source) in words::hostile() {
        let mut rng = Words::new(&mut source);
        for _ in 0..64 {
            let before = rng.drawn;
            let [x, y, z] = Fixed(law).sample(&mut rng).direction();
            let drawn = (rng.drawn.0 - before.0, rng.drawn.1 - before.1);
            assert_eq!(drawn, (words as usize, 0), "{name}: words drawn");
            let length = (x * x + y * y + z * z).sqrt();
            assert!(
                (length - 1.0).abs() <= 4.0 * UNIT,
                "{name}, {generator}: length {length}"
            );
            assert!(y > 0.0 && y < 1.0, "{name}, {generator}: cos θ = {y}");
        }
    }
}

#[test]
fn stuck_generators_give_directions_inside_the_support() {
    open(Lambert, 3, "Lambert");
    open(SphereShell, 4, "SphereShell");
    open(Ball, 5, "Ball");
    open(Disk, 3, "Disk");
    open(CircleShell, 2, "CircleShell");
    open(CircleArc, 1, "CircleArc");
    for k in [U16F16::ZERO, U16F16::ONE, U16F16::from_num(64), U16F16::MAX] {
        open(CosPower::new(k), 3, "CosPower");
    }
}
