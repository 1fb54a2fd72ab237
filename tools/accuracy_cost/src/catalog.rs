//! Our own operations: number type × law × operation.

use crate::arrays::{self, over_pairs};
use crate::contender::{Contender, DIRECTION, EXPONENT, Measure, PARTS, SAMPLE, plain};
use crate::peers;
use coslobe::rand_core::Rng;
use coslobe::{CosSin, Law, Planar, Spatial, uniform};
use kit::catalogue::{every_law, every_number};
use kit::study::cell::{Cell, Draw, generator, generator_cells};
use kit::study::errors;
use kit::study::inputs::{Uniforms, angles, pairs, probabilities};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};
use std::cell::RefCell;
use std::hint::black_box;
use std::marker::PhantomData;

/// Every law in every number type.
struct Ours<'a>(&'a mut Vec<Contender>);

impl NumberVisitor for Ours<'_> {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[EXPONENT]);
    }
}

impl<T: Number> LawVisitor<T> for Ours<'_> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        planar::<T, _>(self.0, id, law);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        spatial::<T, _>(self.0, id, law);
    }
}

/// Everything that is measured, always in the same order.
pub(crate) fn all() -> Vec<Contender> {
    let mut list = Vec::new();
    every_number(&mut Ours(&mut list));
    peers::all(&mut list);
    arrays::all(&mut list);
    list
}

/// All cells in the order that they are counted in: the contenders' that can be, then the
/// generator's.
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
        let list = self.list.iter_mut().filter(|c| c.countable());
        list.map(|c| &mut c.cell).chain(&mut self.generator)
    }

    /// Calls of each cell.
    pub(crate) fn calls(&mut self) -> Vec<u64> {
        self.cells().map(|c| c.calls).collect()
    }
}

fn typed<T: Number>(at: CosSin<T::Raw>) -> CosSin<T> {
    CosSin {
        cos: T::of_raw(at.cos),
        sin: T::of_raw(at.sin),
    }
}

fn add<T: Number>(
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
        width: None,
        cell,
        own: Uniforms::Down(8 * size_of::<uniform::TailBits<T>>() as i32),
        measure,
    });
}

fn law<T: Number, L: Law<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, law: L) {
    let (theta, at) = (angles::<T::Raw>(id.planar()), pairs::<T::Raw>(id.planar()));
    let p = probabilities::<T::Raw>();
    let mut pure = |name, cell| add::<T>(list, id, name, cell, None);
    pure("pdf", Cell::of(&theta, move |x| law.pdf(T::of_raw(x))));
    pure(
        "ln_pdf",
        Cell::of(&theta, move |x| law.ln_pdf(T::of_raw(x))),
    );
    pure("cdf", Cell::of(&theta, move |x| law.cdf(T::of_raw(x))));
    pure("sf", Cell::of(&theta, move |x| law.sf(T::of_raw(x))));
    pure("density", Cell::of(&at, move |x| law.density(typed(x))));
    let weight = Cell::of(&at, move |x| law.lambert_weight(typed(x)));
    pure("lambert_weight", weight);
    pure("unwarp", Cell::of(&at, move |x| law.unwarp(typed(x))));
    pure("unwarp_sf", Cell::of(&at, move |x| law.unwarp_sf(typed(x))));
    pure("warp", Cell::of(&p, move |x| law.warp(T::of_raw(x))));
    pure("warp_sf", Cell::of(&p, move |x| law.warp_sf(T::of_raw(x))));
    pure(
        "quantile",
        Cell::of(&p, move |x| law.quantile(T::of_raw(x))),
    );
    pure("isf", Cell::of(&p, move |x| law.isf(T::of_raw(x))));
}

/// Errors of the directions that a sampler makes of the uniforms that it draws.
fn directions<T: Number, L: Law<T> + Copy + 'static, const N: usize>(
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
            |p| raws(law.warp(T::of_raw(p))),
            |p| raws(law.warp_sf(T::of_raw(p))),
        )
    }))
}

fn planar<T: Number, L: Planar<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, l: L) {
    law::<T, L>(list, id, l);
    let measure = directions(id, l, |at: CosSin<T>| [at.sin, at.cos]);
    let cell = Cell::drawing(InPlane(l, PhantomData::<T>));
    add::<T>(list, id, SAMPLE, cell, measure);
}

fn spatial<T: Number, L: Spatial<T> + Copy + 'static>(list: &mut Vec<Contender>, id: Id, l: L) {
    law::<T, L>(list, id, l);
    let theta = angles::<T::Raw>(false);
    let solid = Cell::of(&theta, move |x| l.pdf_solid_angle(T::of_raw(x)));
    add::<T>(list, id, "pdf_solid_angle", solid, None);
    // Sin θ is judged as the direction holds it, at azimuths all around.
    let rng = RefCell::new(generator());
    let measure = directions(id, l, move |at: CosSin<T>| {
        let azimuth = uniform::azimuth::<T, _>(&mut *rng.borrow_mut());
        [at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin]
    });
    let cell = Cell::drawing(InSpace(l, PhantomData::<T>));
    add::<T>(list, id, SAMPLE, cell, measure);
    let around = Around {
        law: l,
        normal: [0.48, 0.6, 0.64].map(T::of),
    };
    add::<T>(list, id, "sample_around", Cell::drawing(around), None);
    let measure: Measure = Box::new(move |_, n| {
        // On the peers' grid, as a caller's uniforms are.
        errors::of_map::<T::Raw, 3>(id, false, Uniforms::Grid, n, |u| {
            l.warp_direction([u, errors::azimuth(u)].map(T::of_raw))
                .map(T::raw)
        })
    });
    let cell = over_pairs(move |u| l.warp_direction(u));
    add::<T>(list, id, DIRECTION, cell, Some(measure));
    let parts = Parts(l, PhantomData::<T>);
    add::<T>(list, id, PARTS, Cell::drawing(parts), None);
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

/// Of a sample the words and the azimuth.
#[derive(Clone, Copy)]
struct Parts<T, L>(L, PhantomData<T>);

impl<T: Number, L: Spatial<T> + Copy + 'static> Draw for Parts<T, L> {
    type Out = [T; 2];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        let Ok(theta) = self.0.try_draw_theta(rng);
        black_box(theta);
        let CosSin { cos, sin } = uniform::azimuth::<T, _>(rng);
        [cos, sin]
    }
    fn cos(out: &[T; 2]) -> f64 {
        out[0].wide()
    }
}

impl<T: Number, L: Planar<T> + Copy + 'static> Draw for InPlane<T, L> {
    type Out = [T; 2];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        self.0.sample(rng)
    }
    fn cos(out: &[T; 2]) -> f64 {
        out[1].wide()
    }
}

impl<T: Number, L: Spatial<T> + Copy + 'static> Draw for InSpace<T, L> {
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        self.0.sample(rng)
    }
    fn cos(out: &[T; 3]) -> f64 {
        out[1].wide()
    }
}

impl<T: Number, L: Spatial<T> + Copy + 'static> Draw for Around<T, L> {
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        self.law.sample_around(black_box(self.normal), rng)
    }
    fn cos(out: &[T; 3]) -> f64 {
        out[1].wide()
    }
}
