//! Planted faults of a sampler.

use crate::generators::Words;
use coslobe::rand_core::Rng;
use coslobe::self_test::{Alarm, Fault, InPlane, InSpace, Invalid, Place, Report, Subject, Test};
use coslobe::{
    CircleArc, CircleShell, CosPower, CosSin, Disk, Lambert, Law, Planar, Spatial, SphereShell,
    uniform,
};
use std::f32::consts::TAU;

/// Draws from one sampler, claims the law of another.
pub(crate) struct Posing<C, D> {
    claim: C,
    draw: D,
}

impl<C: Subject, D: Fn(&mut dyn Rng) -> C::Sample> Subject for Posing<C, D> {
    type Sample = C::Sample;

    fn draw<R: Rng + ?Sized>(&self, mut rng: &mut R) -> C::Sample {
        (self.draw)(&mut rng)
    }

    fn place(&self, sample: &C::Sample) -> Result<Place, Invalid> {
        self.claim.place(sample)
    }
}

type Draw<const N: usize> = fn(&mut dyn Rng) -> [f32; N];

fn plane<L: Planar<f32>>(law: L, draw: Draw<2>) -> Posing<InPlane<f32, L>, Draw<2>> {
    let claim = InPlane::new(law);
    Posing { claim, draw }
}

fn space<L: Spatial<f32>>(law: L, draw: Draw<3>) -> Posing<InSpace<f32, L>, Draw<3>> {
    let claim = InSpace::new(law);
    Posing { claim, draw }
}

fn lobe(k: f32, rng: &mut dyn Rng) -> [f32; 3] {
    CosPower::new(k).unwrap().sample(rng)
}

/// The usual uniform of so many bits, in the middle of its step so that it is never 0.
fn on_a_grid(bits: u32, rng: &mut dyn Rng) -> [f32; 3] {
    let u = ((rng.next_u32() >> (32 - bits)) as f32 + 0.5) * 0.5f32.powi(bits as i32);
    around(Lambert.warp_sf(u), uniform::azimuth(rng))
}

fn around(at: CosSin<f32>, azimuth: CosSin<f32>) -> [f32; 3] {
    [at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin]
}

/// sin θ without its sign within `degrees` of −90°.
fn sign_lost(degrees: f32, rng: &mut dyn Rng) -> [f32; 2] {
    let [sin, cos]: [f32; 2] = CircleArc.sample(rng);
    let lost = cos < degrees.to_radians().sin();
    [if lost { sin.abs() } else { sin }, cos]
}

/// No azimuth in the last `degrees` of the turn.
fn slice_missing(degrees: f32, rng: &mut dyn Rng) -> [f32; 3] {
    let at = Lambert.warp_tails(uniform::tails(rng));
    let turn = (rng.next_u32() >> 8) as f32 * 0.5f32.powi(24);
    let (sin, cos) = (turn * (TAU - degrees.to_radians())).sin_cos();
    around(at, CosSin { cos, sin })
}

/// The lobe around an axis that is tilted, and folded back above the horizon.
fn tilted(degrees: f32, rng: &mut dyn Rng) -> [f32; 3] {
    let [x, y, z]: [f32; 3] = Lambert.sample(rng);
    let (sin, cos) = degrees.to_radians().sin_cos();
    [x * cos + y * sin, (y * cos - x * sin).abs(), z]
}

/// θ and φ of the same word.
fn one_word(rng: &mut dyn Rng) -> [f32; 3] {
    let word = rng.next_u32();
    let at = Lambert.warp(((word >> 8) as f32 + 0.5) * 0.5f32.powi(24));
    around(at, uniform::azimuth_from_bits::<f32>(word))
}

/// A sine from a coarse table near −90°, as a well-known fixed-point library has it: off by 3.6e-3.
fn coarse_sine(rng: &mut dyn Rng) -> [f32; 2] {
    let [sin, cos]: [f32; 2] = CircleArc.sample(rng);
    [if sin < -0.9999 { sin + 3.6e-3 } else { sin }, cos]
}

/// NaN once in 1000 samples.
fn sometimes_nan(rng: &mut dyn Rng) -> [f32; 3] {
    let [x, y, z]: [f32; 3] = Lambert.sample(rng);
    let nan = rng.next_u32() % 1000 == 0;
    [if nan { f32::NAN } else { x }, y, z]
}

/// What is within 1° of the horizon, put on it.
fn clamped(rng: &mut dyn Rng) -> [f32; 3] {
    let [x, y, z]: [f32; 3] = Lambert.sample(rng);
    let sin = x.hypot(z);
    if y < 1f32.to_radians().sin() {
        [x / sin, 0.0, z / sin]
    } else {
        [x, y, z]
    }
}

/// The verdicts at `stops` samples.
pub(crate) type Run = fn(&mut Words, &[u16]) -> Vec<Verdict>;
pub(crate) type Verdict = Result<Report, Fault>;

pub(crate) fn judged<S: Subject>(subject: S, rng: &mut Words, stops: &[u16]) -> Vec<Verdict> {
    let mut test = Test::new(subject);
    let mut drawn = 0;
    let mut verdicts = Vec::new();
    for &stop in stops {
        test.run(rng, stop - drawn);
        drawn = stop;
        verdicts.push(test.verdict(Alarm::OneInBillion));
    }
    verdicts
}

/// What a fault is called, its run, and the fault that names it in a default test: none where it
/// cannot be seen there.
pub(crate) const FAULTS: &[(&str, Run, Option<&str>)] = &[
    (
        "`CircleArc` for `CircleShell`",
        |rng, at| judged(plane(CircleShell, |rng| CircleArc.sample(rng)), rng, at),
        Some("Eighths"),
    ),
    (
        "`CircleShell` for `Disk`",
        |rng, at| judged(plane(Disk, |rng| CircleShell.sample(rng)), rng, at),
        Some("Eighths"),
    ),
    (
        "`Lambert` for `SphereShell`",
        |rng, at| judged(space(SphereShell, |rng| Lambert.sample(rng)), rng, at),
        Some("Eighths"),
    ),
    (
        "k = 2.5 for 2",
        |rng, at| judged(space(SphereShell, |rng| lobe(2.5, rng)), rng, at),
        Some("Eighths"),
    ),
    (
        "k = 2.2 for 2",
        |rng, at| judged(space(SphereShell, |rng| lobe(2.2, rng)), rng, at),
        None,
    ),
    (
        "k = 2.05 for 2",
        |rng, at| judged(space(SphereShell, |rng| lobe(2.05, rng)), rng, at),
        None,
    ),
    (
        "k = 1.95 for 2",
        |rng, at| judged(space(SphereShell, |rng| lobe(1.95, rng)), rng, at),
        None,
    ),
    (
        "u of 24 bits",
        |rng, at| judged(space(Lambert, |rng| on_a_grid(24, rng)), rng, at),
        None,
    ),
    (
        "u of 12 bits",
        |rng, at| judged(space(Lambert, |rng| on_a_grid(12, rng)), rng, at),
        None,
    ),
    (
        "u of 8 bits",
        |rng, at| judged(space(Lambert, |rng| on_a_grid(8, rng)), rng, at),
        Some("Polar"),
    ),
    (
        "sign of sin θ lost within 2° of −90°",
        |rng, at| judged(plane(CircleArc, |rng| sign_lost(2.0, rng)), rng, at),
        Some("Eighths or Polar"),
    ),
    (
        "sign of sin θ lost within 0.5° of −90°",
        |rng, at| judged(plane(CircleArc, |rng| sign_lost(0.5, rng)), rng, at),
        None,
    ),
    (
        "sign of sin θ lost within 0.1° of −90°",
        |rng, at| judged(plane(CircleArc, |rng| sign_lost(0.1, rng)), rng, at),
        None,
    ),
    (
        "sin θ off by 3.6e-3 within 0.8° of −90°",
        |rng, at| judged(plane(CircleArc, coarse_sine), rng, at),
        Some("Invalid"),
    ),
    (
        "22.5° of φ missing",
        |rng, at| judged(space(Lambert, |rng| slice_missing(22.5, rng)), rng, at),
        Some("Azimuth"),
    ),
    (
        "5° of φ missing",
        |rng, at| judged(space(Lambert, |rng| slice_missing(5.0, rng)), rng, at),
        None,
    ),
    (
        "1° of φ missing",
        |rng, at| judged(space(Lambert, |rng| slice_missing(1.0, rng)), rng, at),
        None,
    ),
    (
        "axis tilted by 10°",
        |rng, at| judged(space(Lambert, |rng| tilted(10.0, rng)), rng, at),
        Some("Azimuth"),
    ),
    (
        "axis tilted by 5°",
        |rng, at| judged(space(Lambert, |rng| tilted(5.0, rng)), rng, at),
        Some("Azimuth"),
    ),
    (
        "axis tilted by 2°",
        |rng, at| judged(space(Lambert, |rng| tilted(2.0, rng)), rng, at),
        None,
    ),
    (
        "θ and φ of one word",
        |rng, at| judged(space(Lambert, one_word), rng, at),
        Some("PolarAzimuth"),
    ),
    (
        "NaN once in 1000",
        |rng, at| judged(space(Lambert, sometimes_nan), rng, at),
        Some("Invalid"),
    ),
    (
        "cos θ = 0 within 1° of the horizon",
        |rng, at| judged(space(Lambert, clamped), rng, at),
        Some("Invalid"),
    ),
];
