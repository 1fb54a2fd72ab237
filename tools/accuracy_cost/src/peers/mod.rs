//! The same directions and functions as others compute them, each in its own usual way.
//!
//! All draw from the same generator as ours. The formulas are the publications' or the textbook's;
//! the code is this study's.

mod concentric;
mod lobe;
mod maths;
mod planar;
mod points;
mod rejection;
mod root_finder;
mod textbook;

use crate::arrays::over_pairs;
use crate::contender::{Contender, DIRECTION, Measure, SAMPLE, plain};
use coslobe::rand_core::Rng;
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use kit::study::cell::{Cell, Draw};
use kit::study::errors;
use kit::study::inputs::Uniforms;
use rand::RngExt;
use rand::distr::{Distribution, StandardUniform};
use std::marker::PhantomData;

pub(crate) fn all(list: &mut Vec<Contender>) {
    lobe::all(list);
    concentric::all(list);
    points::all(list);
    rejection::all(list);
    planar::all(list);
    root_finder::all(list);
    textbook::all(list);
}

/// What a peer's row says of it.
#[derive(Clone, Copy)]
struct About {
    name: &'static str,
    short: &'static str,
    library: &'static str,
    law: Id,
}

fn push<T: Format>(
    list: &mut Vec<Contender>,
    about: About,
    operation: &'static str,
    cell: Cell,
    measure: Measure,
) {
    list.push(Contender {
        name: format!("{}, {} {}", about.name, about.library, T::NAME),
        short: format!("{} {} {}", about.short, about.library, T::NAME),
        ours: false,
        format: plain(T::NAME),
        law: about.law,
        operation,
        width: None,
        cell,
        own: Uniforms::Grid,
        measure: Some(measure),
    });
}

/// A direction of one or two uniforms on `rand`'s grid.
struct Mapped<T, F>(F, PhantomData<T>);

impl<T, F: Copy> Clone for Mapped<T, F> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T, F: Copy> Copy for Mapped<T, F> {}

impl<T, F> Draw for Mapped<T, F>
where
    T: Format,
    StandardUniform: Distribution<T>,
    F: Fn(T, T) -> [T; 3] + Copy + 'static,
{
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        let u = rng.random();
        (self.0)(u, rng.random())
    }
    fn cos(out: &[T; 3]) -> f64 {
        out[1].wide()
    }
}

/// A spatial sampler whose first uniform is the sf of θ and whose second is the azimuth.
fn spatial<T, F>(list: &mut Vec<Contender>, about: About, f: F)
where
    T: Format,
    StandardUniform: Distribution<T>,
    F: Fn(T, T) -> [T; 3] + Copy + 'static,
{
    mapped::<T, F>(list, about, f, || {
        Box::new(move |from, n| {
            errors::of_map(about.law, true, from, n, |u| f(u, errors::azimuth(u)))
        })
    });
}

/// A map of the square, drawn through and over an array of pairs.
fn mapped<T, F>(list: &mut Vec<Contender>, about: About, f: F, measure: impl Fn() -> Measure)
where
    T: Format,
    StandardUniform: Distribution<T>,
    F: Fn(T, T) -> [T; 3] + Copy + 'static,
{
    let drawn = Cell::drawing(Mapped(f, PhantomData::<T>));
    push::<T>(list, about, SAMPLE, drawn, measure());
    let loop_of_pairs = over_pairs(move |[u, v]| f(u, v));
    push::<T>(list, about, DIRECTION, loop_of_pairs, measure());
}

/// A direction of one uniform in the plane.
struct Flat<T, F>(F, PhantomData<T>);

impl<T, F: Copy> Clone for Flat<T, F> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T, F: Copy> Copy for Flat<T, F> {}

impl<T, F> Draw for Flat<T, F>
where
    T: Format,
    StandardUniform: Distribution<T>,
    F: Fn(T) -> [T; 2] + Copy + 'static,
{
    type Out = [T; 2];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 2] {
        (self.0)(rng.random())
    }
    fn cos(out: &[T; 2]) -> f64 {
        out[1].wide()
    }
}

/// A planar sampler whose uniform is the cdf of θ.
fn flat<T, F>(list: &mut Vec<Contender>, about: About, f: F)
where
    T: Format,
    StandardUniform: Distribution<T>,
    F: Fn(T) -> [T; 2] + Copy + 'static,
{
    let measure: Measure = Box::new(move |from, n| errors::of_map(about.law, false, from, n, f));
    let cell = Cell::drawing(Flat(f, PhantomData::<T>));
    push::<T>(list, about, SAMPLE, cell, measure);
}
