//! Our own operations: number type × law × operation.

use crate::accuracy::format::Format;
use crate::accuracy::reference::Id;
use crate::cell::{Cell, Draw, generator, generator_cells};
use crate::contender::{Contender, Measure, plain};
use crate::errors;
use crate::inputs::{Uniforms, angles, pairs, probabilities};
use crate::peers;
use coslobe::rand_core::Rng;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Lambert, Law, Planar, Spatial, SphereShell,
    uniform,
};
use std::hint::black_box;
use std::marker::PhantomData;

/// Exponent of the power law that is measured.
pub(crate) const EXPONENT: f64 = 20.0;

/// The number types that are measured: a new one is one line here.
fn types(list: &mut Vec<Contender>) {
    number::<f32>(list);
    number::<f64>(list);
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

fn number<T: Format>(list: &mut Vec<Contender>) {
    planar::<T, _>(list, Id::Disk, Disk);
    planar::<T, _>(list, Id::CircleShell, CircleShell);
    planar::<T, _>(list, Id::CircleArc, CircleArc);
    spatial::<T, _>(list, Id::Ball, Ball);
    spatial::<T, _>(list, Id::SphereShell, SphereShell);
    spatial::<T, _>(list, Id::Lambert, Lambert);
    let power = CosPower::new(T::round(EXPONENT)).expect("a valid exponent");
    spatial::<T, _>(list, Id::CosPower(EXPONENT), power);
}

fn add<T: Format>(
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
        own: Uniforms::Full,
        measure,
    });
}

fn law<T: Format, L: Law<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, law: L) {
    let (theta, at) = (angles::<T>(id.planar()), pairs::<T>(id.planar()));
    let p = probabilities::<T>();
    let mut pure = |name, cell| add::<T>(list, id, name, cell, None);
    pure("pdf", Cell::of(&theta, move |x| law.pdf(x)));
    pure("ln_pdf", Cell::of(&theta, move |x| law.ln_pdf(x)));
    pure("cdf", Cell::of(&theta, move |x| law.cdf(x)));
    pure("sf", Cell::of(&theta, move |x| law.sf(x)));
    pure("density", Cell::of(&at, move |x| law.density(x)));
    let weight = Cell::of(&at, move |x| law.lambert_weight(x));
    pure("lambert_weight", weight);
    pure("unwarp", Cell::of(&at, move |x| law.unwarp(x)));
    pure("unwarp_sf", Cell::of(&at, move |x| law.unwarp_sf(x)));
    pure("warp", Cell::of(&p, move |x| law.warp(x)));
    pure("warp_sf", Cell::of(&p, move |x| law.warp_sf(x)));
    pure("isf", Cell::of(&p, move |x| law.isf(x)));
    let cell = Cell::of(&p, move |x| law.quantile(x));
    let measure: Measure =
        Box::new(move |_, n| errors::of_quantile::<T>(id, n, |u| law.quantile(u)));
    add::<T>(list, id, "quantile", cell, Some(measure));
}

fn planar<T: Format, L: Planar<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, l: L) {
    law::<T, L>(list, id, l);
    let measure: Measure = Box::new(move |from, n| {
        let direction = |at: coslobe::CosSin<T>| vec![at.sin, at.cos];
        errors::of_entries::<T>(id, from, n, |p| l.warp(p), |p| l.warp_sf(p), direction)
    });
    let cell = Cell::drawing(InPlane(l, PhantomData::<T>));
    add::<T>(list, id, "sample", cell, Some(measure));
}

fn spatial<T: Format, L: Spatial<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, l: L) {
    law::<T, L>(list, id, l);
    let solid = Cell::of(&angles::<T>(false), move |x| l.pdf_solid_angle(x));
    add::<T>(list, id, "pdf_solid_angle", solid, None);
    let measure: Measure = Box::new(move |from, n| {
        // Some azimuth: sin θ is judged as the direction holds it.
        let azimuth = uniform::azimuth::<T, _>(&mut generator());
        let direction =
            |at: coslobe::CosSin<T>| vec![at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin];
        errors::of_entries::<T>(id, from, n, |p| l.warp(p), |p| l.warp_sf(p), direction)
    });
    let cell = Cell::drawing(InSpace(l, PhantomData::<T>));
    add::<T>(list, id, "sample", cell, Some(measure));
    let around = Around {
        law: l,
        normal: [0.48, 0.6, 0.64].map(T::round),
    };
    add::<T>(list, id, "sample_around", Cell::drawing(around), None);
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

impl<T: Format, L: Planar<T> + Copy + 'static> Draw for InPlane<T, L> {
    type Out = [T; 2];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        self.0.sample(rng)
    }
}

impl<T: Format, L: Spatial<T> + Copy + 'static> Draw for InSpace<T, L> {
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        self.0.sample(rng)
    }
}

impl<T: Format, L: Spatial<T> + Copy + 'static> Draw for Around<T, L> {
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        self.law.sample_around(black_box(self.normal), rng)
    }
}
