//! What others would write, and what the generator costs by itself.

use crate::Meter;
use crate::generator::Generator;
use crate::inputs::{angles, probabilities};
use crate::laws::{EXPONENT, counted_name};
use core::marker::PhantomData;
use coslobe::rand_core::Rng;
use kit::formulas::{Maths, Plane, Space, lambert_by_idsp};
use kit::{Id, LawVisitor, Named, PlanarLaw, SpatialLaw, catalogue};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// Every law in a library's functions, in the type of ours.
pub fn every_law<M: Maths>(meter: &mut Meter) {
    catalogue::every_law::<f32>(&mut Counted::<M>(meter, PhantomData), &[EXPONENT]);
}

struct Counted<'a, 'm, M>(&'a mut Meter<'m>, PhantomData<M>);

impl<M: Maths> LawVisitor<f32> for Counted<'_, '_, M> {
    fn planar<L: PlanarLaw<f32>>(&mut self, _: Id, law: L) {
        plane::<M, L>(self.0, L::ID.name(), &law);
    }
    fn spatial<L: SpatialLaw<f32>>(&mut self, id: Id, law: L) {
        space::<M, L>(self.0, counted_name(id), &law);
    }
}

/// A uniform number on the usual grid of 2⁻²⁴.
#[inline(always)]
fn uniform(rng: &mut impl Rng) -> f32 {
    (rng.next_u32() >> 8) as f32 * (1.0 / (1 << 24) as f32)
}

const fn planar<L: Named>() -> Plane {
    Plane::of(L::ID).expect("a law of the plane")
}

const fn solid<L: Named>() -> Space {
    Space::of(L::ID).expect("a law of space")
}

fn in_plane<M: Maths, L: Named, R: Rng>(_: &L, rng: &mut R) -> [f32; 2] {
    const { planar::<L>() }.direction::<M>(uniform(rng), || uniform(rng))
}

fn in_space<M: Maths, L: Named, R: Rng>(_: &L, rng: &mut R) -> [f32; 3] {
    const { solid::<L>() }.direction::<M>(uniform(rng), uniform(rng))
}

fn plane<M: Maths, L: Named>(meter: &mut Meter, name: &'static str, law: &L) {
    meter.law(name);
    let (theta, p) = (angles::<f32>(true), probabilities::<f32>());
    meter.call(
        "pdf",
        law,
        &theta,
        |_, x| const { planar::<L>() }.pdf::<M>(x),
        |_, x| x,
    );
    meter.call(
        "cdf",
        law,
        &theta,
        |_, x| const { planar::<L>() }.cdf::<M>(x),
        |_, x| x,
    );
    if const { planar::<L>() } != Plane::Disk {
        let quantile = |_: &L, p| const { planar::<L>() }.quantile::<M>(p).unwrap_or(p);
        meter.call("quantile", law, &p, quantile, |_, x| x);
    }
    meter.draw::<Pcg32, _, _>(law, in_plane::<M, L, _>, |_, _| [0.0; 2]);
    meter.draw::<XorShiftRng, _, _>(law, in_plane::<M, L, _>, |_, _| [0.0; 2]);
}

fn space<M: Maths, L: Named>(meter: &mut Meter, name: &'static str, law: &L) {
    meter.law(name);
    let (theta, p) = (angles::<f32>(false), probabilities::<f32>());
    meter.call(
        "pdf",
        law,
        &theta,
        |_, x| const { solid::<L>() }.pdf::<M>(x),
        |_, x| x,
    );
    meter.call(
        "cdf",
        law,
        &theta,
        |_, x| const { solid::<L>() }.cdf::<M>(x),
        |_, x| x,
    );
    meter.call(
        "quantile",
        law,
        &p,
        |_, p| const { solid::<L>() }.quantile::<M>(p),
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
