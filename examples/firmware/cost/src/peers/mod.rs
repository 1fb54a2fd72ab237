//! What others would write, and what the generator costs by itself.

use crate::Meter;
use crate::generator::Generator;
use crate::inputs::{angles, probabilities};
use coslobe::rand_core::Rng;
use kit::formulas::{Maths, Plane, Space, lambert_by_idsp};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// A law as a type, so that a function's pointer says which one it is of.
trait Is<Kind> {
    const LAW: Kind;
}

struct Disk;
struct CircleShell;
struct CircleArc;
struct Ball;
struct SphereShell;
struct Lambert;
struct CosPower;

impl Is<Plane> for Disk {
    const LAW: Plane = Plane::Disk;
}
impl Is<Plane> for CircleShell {
    const LAW: Plane = Plane::CircleShell;
}
impl Is<Plane> for CircleArc {
    const LAW: Plane = Plane::CircleArc;
}
impl Is<Space> for Ball {
    const LAW: Space = Space::Ball;
}
impl Is<Space> for SphereShell {
    const LAW: Space = Space::SphereShell;
}
impl Is<Space> for Lambert {
    const LAW: Space = Space::Lambert;
}
impl Is<Space> for CosPower {
    const LAW: Space = Space::CosPower;
}

/// Every law in a library's functions.
pub fn every_law<M: Maths>(meter: &mut Meter) {
    plane::<M, _>(meter, "Disk", &Disk);
    plane::<M, _>(meter, "CircleShell", &CircleShell);
    plane::<M, _>(meter, "CircleArc", &CircleArc);
    space::<M, _>(meter, "Ball", &Ball);
    space::<M, _>(meter, "SphereShell", &SphereShell);
    space::<M, _>(meter, "Lambert", &Lambert);
    space::<M, _>(meter, "CosPower(20)", &CosPower);
}

/// A uniform number on the usual grid of 2⁻²⁴.
#[inline(always)]
fn uniform(rng: &mut impl Rng) -> f32 {
    (rng.next_u32() >> 8) as f32 * (1.0 / (1 << 24) as f32)
}

fn in_plane<M: Maths, L: Is<Plane>, R: Rng>(_: &L, rng: &mut R) -> [f32; 2] {
    L::LAW.direction::<M>(uniform(rng), || uniform(rng))
}

fn in_space<M: Maths, L: Is<Space>, R: Rng>(_: &L, rng: &mut R) -> [f32; 3] {
    L::LAW.direction::<M>(uniform(rng), uniform(rng))
}

fn plane<M: Maths, L: Is<Plane>>(meter: &mut Meter, name: &'static str, law: &L) {
    meter.law(name);
    let (theta, p) = (angles::<f32>(true), probabilities::<f32>());
    meter.call("pdf", law, &theta, |_, x| L::LAW.pdf::<M>(x), |_, x| x);
    meter.call("cdf", law, &theta, |_, x| L::LAW.cdf::<M>(x), |_, x| x);
    if L::LAW != Plane::Disk {
        let quantile = |_: &L, p| L::LAW.quantile::<M>(p).unwrap_or(p);
        meter.call("quantile", law, &p, quantile, |_, x| x);
    }
    meter.draw::<Pcg32, _, _>(law, in_plane::<M, L, _>, |_, _| [0.0; 2]);
    meter.draw::<XorShiftRng, _, _>(law, in_plane::<M, L, _>, |_, _| [0.0; 2]);
}

fn space<M: Maths, L: Is<Space>>(meter: &mut Meter, name: &'static str, law: &L) {
    meter.law(name);
    let (theta, p) = (angles::<f32>(false), probabilities::<f32>());
    meter.call("pdf", law, &theta, |_, x| L::LAW.pdf::<M>(x), |_, x| x);
    meter.call("cdf", law, &theta, |_, x| L::LAW.cdf::<M>(x), |_, x| x);
    meter.call(
        "quantile",
        law,
        &p,
        |_, p| L::LAW.quantile::<M>(p),
        |_, x| x,
    );
    meter.draw::<Pcg32, _, _>(law, in_space::<M, L, _>, |_, _| [0.0; 3]);
    meter.draw::<XorShiftRng, _, _>(law, in_space::<M, L, _>, |_, _| [0.0; 3]);
}

/// Lambert's law in integers.
pub fn idsp(meter: &mut Meter) {
    meter.law("Lambert");
    integers::<Pcg32>(meter);
    integers::<XorShiftRng>(meter);
}

fn integers<R: Generator>(meter: &mut Meter) {
    let f = |_: &(), rng: &mut R| lambert_by_idsp(rng.next_u32(), rng.next_u32());
    meter.draw(&(), f, |_, _| [0; 3]);
}

/// What each sampler's cost has in it.
pub fn generators(meter: &mut Meter) {
    meter.law("Pcg32");
    words::<Pcg32>(meter);
    meter.law("XorShiftRng");
    words::<XorShiftRng>(meter);
}

fn words<R: Generator>(meter: &mut Meter) {
    meter.draw_as("next_u32", &(), |_, rng: &mut R| rng.next_u32(), |_, _| 0);
    meter.draw_as("next_u64", &(), |_, rng: &mut R| rng.next_u64(), |_, _| 0);
}
