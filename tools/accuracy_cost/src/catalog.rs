//! Our own operations: number type × law × operation.

use crate::contender::{Contender, Measure, PARTS, plain};
use crate::peers;
use coslobe::rand_core::Rng;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Fast, Lambert, Law, Planar, Precise,
    Spatial, SphereShell, uniform,
};
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use kit::accuracy::values::Tier;
use kit::study::cell::{Cell, Draw, generator, generator_cells};
use kit::study::errors;
use kit::study::inputs::{Uniforms, angles, pairs, probabilities};
use std::hint::black_box;
use std::marker::PhantomData;

/// Exponent of the power law that is measured.
pub(crate) const EXPONENT: f64 = 20.0;

/// The number types that are measured: a new one is one line here.
fn types(list: &mut Vec<Contender>) {
    number::<f32>(list);
    number::<f64>(list);
    number::<Precise<f32>>(list);
    number::<Precise<f64>>(list);
    number::<Fast<f32>>(list);
}

/// Everything that is measured, always in the same order.
fn all() -> Vec<Contender> {
    let mut list = Vec::new();
    types(&mut list);
    peers::all(&mut list);
    list
}

/// All cells in the order that they are counted in: the contenders', then the generator's.
pub(crate) struct Counted {
    pub(crate) list: Vec<Contender>,
    pub(crate) generator: [Cell; 2],
}

impl Counted {
    pub(crate) fn new() -> Counted {
        Counted {
            list: all(),
            generator: generator_cells(),
        }
    }

    pub(crate) fn cells(&mut self) -> impl Iterator<Item = &mut Cell> {
        let list = self.list.iter_mut().map(|c| &mut c.cell);
        list.chain(&mut self.generator)
    }

    /// Calls of each cell.
    pub(crate) fn calls(&mut self) -> Vec<u64> {
        self.cells().map(|c| c.calls).collect()
    }
}

fn number<T: Tier>(list: &mut Vec<Contender>) {
    planar::<T, _>(list, Id::Disk, Disk);
    planar::<T, _>(list, Id::CircleShell, CircleShell);
    planar::<T, _>(list, Id::CircleArc, CircleArc);
    spatial::<T, _>(list, Id::Ball, Ball);
    spatial::<T, _>(list, Id::SphereShell, SphereShell);
    spatial::<T, _>(list, Id::Lambert, Lambert);
    let power = CosPower::new(of::<T>(EXPONENT)).expect("a valid exponent");
    spatial::<T, _>(list, Id::CosPower(EXPONENT), power);
}

fn of<T: Tier>(x: f64) -> T {
    T::of(T::Raw::round(x))
}

fn typed<T: Tier>(at: CosSin<T::Raw>) -> CosSin<T> {
    CosSin {
        cos: T::of(at.cos),
        sin: T::of(at.sin),
    }
}

fn add<T: Tier>(
    list: &mut Vec<Contender>,
    law: Id,
    operation: &'static str,
    cell: Cell,
    measure: Option<Measure>,
) {
    list.push(Contender {
        name: T::NAME.to_owned(),
        short: T::NAME.to_owned(),
        ours: true,
        format: plain(T::NAME),
        law,
        operation,
        cell,
        own: Uniforms::Down(8 * size_of::<uniform::TailBits<T>>() as i32),
        measure,
    });
}

fn law<T: Tier, L: Law<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, law: L) {
    let (theta, at) = (angles::<T::Raw>(id.planar()), pairs::<T::Raw>(id.planar()));
    let p = probabilities::<T::Raw>();
    let mut pure = |name, cell| add::<T>(list, id, name, cell, None);
    pure("pdf", Cell::of(&theta, move |x| law.pdf(T::of(x))));
    pure("ln_pdf", Cell::of(&theta, move |x| law.ln_pdf(T::of(x))));
    pure("cdf", Cell::of(&theta, move |x| law.cdf(T::of(x))));
    pure("sf", Cell::of(&theta, move |x| law.sf(T::of(x))));
    pure("density", Cell::of(&at, move |x| law.density(typed(x))));
    let weight = Cell::of(&at, move |x| law.lambert_weight(typed(x)));
    pure("lambert_weight", weight);
    pure("unwarp", Cell::of(&at, move |x| law.unwarp(typed(x))));
    pure("unwarp_sf", Cell::of(&at, move |x| law.unwarp_sf(typed(x))));
    pure("warp", Cell::of(&p, move |x| law.warp(T::of(x))));
    pure("warp_sf", Cell::of(&p, move |x| law.warp_sf(T::of(x))));
    pure("quantile", Cell::of(&p, move |x| law.quantile(T::of(x))));
    pure("isf", Cell::of(&p, move |x| law.isf(T::of(x))));
}

/// Errors of the directions that a sampler makes of the uniforms that it draws.
fn directions<T: Tier, L: Law<T> + Copy + 'static, const N: usize>(
    id: Id,
    law: L,
    direction: impl Fn(CosSin<T>) -> [T; N] + 'static,
) -> Option<Measure> {
    Some(Box::new(move |from, n| {
        let raws = |at: CosSin<T>| direction(at).map(T::raw);
        errors::of_entries::<T::Raw, N>(
            id,
            from,
            n,
            |p| raws(law.warp(T::of(p))),
            |p| raws(law.warp_sf(T::of(p))),
        )
    }))
}

fn planar<T: Tier, L: Planar<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, l: L) {
    law::<T, L>(list, id, l);
    let measure = directions(id, l, |at: CosSin<T>| [at.sin, at.cos]);
    let cell = Cell::drawing(InPlane(l, PhantomData::<T>));
    add::<T>(list, id, "sample", cell, measure);
}

fn spatial<T: Tier, L: Spatial<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, l: L) {
    law::<T, L>(list, id, l);
    let theta = angles::<T::Raw>(false);
    let solid = Cell::of(&theta, move |x| l.pdf_solid_angle(T::of(x)));
    add::<T>(list, id, "pdf_solid_angle", solid, None);
    // Some azimuth: sin θ is judged as the direction holds it.
    let azimuth = uniform::azimuth::<T, _>(&mut generator());
    let measure = directions(id, l, move |at: CosSin<T>| {
        [at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin]
    });
    let cell = Cell::drawing(InSpace(l, PhantomData::<T>));
    add::<T>(list, id, "sample", cell, measure);
    let around = Around {
        law: l,
        normal: [0.48, 0.6, 0.64].map(of::<T>),
    };
    add::<T>(list, id, "sample_around", Cell::drawing(around), None);
    add::<T>(
        list,
        id,
        PARTS,
        Cell::drawing(Parts(PhantomData::<T>)),
        None,
    );
}

#[derive(Clone, Copy)]
struct InPlane<T, L>(L, PhantomData<T>);
#[derive(Clone, Copy)]
struct InSpace<T, L>(L, PhantomData<T>);
#[derive(Clone, Copy)]
struct Around<T, L> {
    law: L,
    normal: [T; 3],
}

#[derive(Clone, Copy)]
struct Parts<T>(PhantomData<T>);

impl<T: Tier> Draw for Parts<T> {
    type Out = [T; 4];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 4] {
        let tails = uniform::tails::<T, _>(rng);
        let azimuth = uniform::azimuth::<T, _>(rng);
        [tails.lower(), tails.upper(), azimuth.cos, azimuth.sin]
    }
    fn cos(out: &[T; 4]) -> f64 {
        out[1].raw().wide()
    }
}

impl<T: Tier, L: Planar<T> + Copy + 'static> Draw for InPlane<T, L> {
    type Out = [T; 2];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        self.0.sample(rng)
    }
    fn cos(out: &[T; 2]) -> f64 {
        out[1].raw().wide()
    }
}

impl<T: Tier, L: Spatial<T> + Copy + 'static> Draw for InSpace<T, L> {
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        self.0.sample(rng)
    }
    fn cos(out: &[T; 3]) -> f64 {
        out[1].raw().wide()
    }
}

impl<T: Tier, L: Spatial<T> + Copy + 'static> Draw for Around<T, L> {
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        self.law.sample_around(black_box(self.normal), rng)
    }
    fn cos(out: &[T; 3]) -> f64 {
        out[1].raw().wide()
    }
}
