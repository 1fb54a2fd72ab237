//! What the C program has to print: every law of the catalogue, in C's four number types.

use super::lines::{Lines, Word};
use coslobe::integers::{
    CosPower, Fixed16Law, Fixed16Planar, Fixed16Spatial, FixedLaw, FixedPlanar, FixedRadius,
    FixedSpatial,
};
use coslobe::{Fast, Fixed, Fixed16, Law, Planar, Radius, Spatial, self_test};
use fixed::types::{I1F15, I1F31, I16F0, I32F0};
use kit::catalogue::{EXPONENT, IntegerLaw, IntegerVisitor, every_integer_law, every_law};
use kit::{Id, LawVisitor, Named, Number, PlanarLaw, SpatialLaw, TangentLaw};
use std::marker::PhantomData;

const NORMAL: [f64; 3] = [0.6, 0.0, -0.8];
const RADIUS: f64 = 2.5;

/// All lines, in the order of their names.
pub(super) fn expected() -> String {
    let mut text = String::new();
    every_law(
        &mut Floats::<f32>(&mut text, "f32", PhantomData),
        &[EXPONENT],
    );
    every_law(
        &mut Floats::<Fast<f32>>(&mut text, "fast", PhantomData),
        &[EXPONENT],
    );
    every_integer_law(&mut Integers(&mut text));
    sorted(&(text + "refused as documented\n"))
}

/// The lines of `output` in that order.
pub(super) fn sorted(output: &str) -> String {
    let mut lines: Vec<_> = output.lines().collect();
    lines.sort_unstable();
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// `CircleShell` is `circle_shell` in C.
fn c_name(id: Id) -> String {
    let mut name = String::new();
    for letter in id.name().chars() {
        if letter.is_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.extend(letter.to_lowercase());
    }
    name
}

impl Word for Fast<f32> {
    fn from_word(word: u32) -> Self {
        Fast(f32::from_word(word))
    }
    fn bits(self) -> u32 {
        Word::bits(self.0)
    }
}

struct Floats<'a, T>(&'a mut String, &'static str, PhantomData<T>);

impl<T: Number + Word> Floats<'_, T> {
    fn lines(&mut self, id: Id, l: &impl Law<T>) -> Lines<'_> {
        let mut lines = Lines {
            text: self.0,
            law: c_name(id),
            number: self.1,
        };
        lines.value("pdf", |x| l.pdf(x));
        lines.value("ln_pdf", |x| l.ln_pdf(x));
        lines.value("cdf", |x| l.cdf(x));
        lines.value("sf", |x| l.sf(x));
        lines.value("quantile", |x| l.quantile(x));
        lines.value("isf", |x| l.isf(x));
        lines.pair("warp", |x| l.warp(x));
        lines.pair("warp_sf", |x| l.warp_sf(x));
        lines.of_pair("unwarp", |at| l.unwarp(at));
        lines.of_pair("unwarp_sf", |at| l.unwarp_sf(at));
        lines.of_pair("density", |at| l.density(at));
        lines.of_pair("lambert_weight", |at| l.lambert_weight(at));
        lines
    }
}

fn radius<T: Number>() -> Radius<T> {
    Radius::new(T::of(RADIUS)).expect("a radius")
}

impl<T: Number + Word> LawVisitor<T> for Floats<'_, T> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let mut lines = self.lines(id, &law);
        lines.sample(|rng| Planar::sample(&law, rng));
        lines.draws("point", |rng| law.sample_point(radius(), rng));
        lines.self_test(self_test::planar::<T, _>(law));
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let mut lines = self.lines(id, &law);
        lines.value("pdf_solid_angle", |x| law.pdf_solid_angle(x));
        lines.sample(|rng| Spatial::sample(&law, rng));
        lines.draws("sample_around", |rng| {
            law.sample_around(NORMAL.map(T::of), rng)
        });
        lines.warped(|u| law.warp_direction(u));
        lines.self_test(self_test::spatial::<T, _>(law));
    }

    fn tangent<L: TangentLaw<T>>(&mut self, id: Id, law: L) {
        self.spatial(id, law);
        let mut lines = Lines {
            text: self.0,
            law: c_name(id),
            number: self.1,
        };
        lines.draws("point", |rng| law.sample_point(radius(), rng));
    }
}

struct Integers<'a>(&'a mut String);

// The two formats have no trait in common that a user could name: the same lines twice.

fn q31<L: FixedLaw<Density: Word> + Named + Copy>(text: &mut String, l: L) -> Lines<'_> {
    let mut lines = Lines {
        text,
        law: c_name(L::ID),
        number: "q31",
    };
    let l = Fixed(l);
    lines.value("pdf", |x| l.pdf(x));
    lines.value("cdf", |x| l.cdf(x));
    lines.value("sf", |x| l.sf(x));
    lines.value("quantile", |x| l.quantile(x));
    lines.value("isf", |x| l.isf(x));
    lines.pair("warp", |x| l.warp(x));
    lines.pair("warp_sf", |x| l.warp_sf(x));
    lines.of_pair("unwarp", |at| l.unwarp(at));
    lines.of_pair("unwarp_sf", |at| l.unwarp_sf(at));
    lines.of_pair("density", |at| l.density(at));
    lines.of_pair("lambert_weight", |at| l.lambert_weight(at));
    lines
}

fn q15<L: Fixed16Law + Named + Copy>(text: &mut String, l: L) -> Lines<'_> {
    let mut lines = Lines {
        text,
        law: c_name(L::ID),
        number: "q15",
    };
    let l = Fixed16(l);
    lines.value("pdf", |x| l.pdf(x));
    lines.value("cdf", |x| l.cdf(x));
    lines.value("sf", |x| l.sf(x));
    lines.value("quantile", |x| l.quantile(x));
    lines.value("isf", |x| l.isf(x));
    lines.pair("warp", |x| l.warp(x));
    lines.pair("warp_sf", |x| l.warp_sf(x));
    lines.of_pair("unwarp", |at| l.unwarp(at));
    lines.of_pair("unwarp_sf", |at| l.unwarp_sf(at));
    lines.of_pair("density", |at| l.density(at));
    lines.of_pair("lambert_weight", |at| l.lambert_weight(at));
    lines
}

/// The largest radius.
fn units() -> FixedRadius<I32F0> {
    FixedRadius::new(I32F0::MAX >> 2).expect("a radius")
}

fn short_units() -> FixedRadius<I16F0> {
    FixedRadius::new(I16F0::MAX >> 2).expect("a radius")
}

/// What the laws of space have besides, of 32 bits.
fn q31_in_space<L>(lines: &mut Lines, law: L)
where
    L: FixedSpatial + FixedLaw<Density: Word> + Named + Copy,
{
    let law = Fixed(law);
    lines.value("pdf_solid_angle", |x| law.pdf_solid_angle(x));
    lines.sample(|rng| law.sample(rng));
    let normal = [0x4ccc_cccd, 0, -0x6666_6666].map(I1F31::from_bits);
    lines.draws("sample_around", |rng| law.sample_around(normal, rng));
    lines.warped(|u| law.warp_direction(u));
    lines.self_test(self_test::fixed(law));
}

impl IntegerVisitor for Integers<'_> {
    fn law<L: IntegerLaw>(&mut self, _: L) {
        unreachable!("each is of the plane or of space");
    }

    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, law: L) {
        let mut lines = q31(self.0, law);
        lines.sample(|rng| Fixed(law).sample(rng));
        lines.draws("point", |rng| Fixed(law).sample_point(units(), rng));
        lines.self_test(self_test::fixed(Fixed(law)));
        let mut lines = q15(self.0, law);
        lines.sample(|rng| Fixed16(law).sample(rng));
        lines.draws("point", |rng| Fixed16(law).sample_point(short_units(), rng));
        lines.self_test(self_test::fixed(Fixed16(law)));
    }

    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        let mut lines = q31(self.0, law);
        lines.draws("point", |rng| Fixed(law).sample_point(units(), rng));
        q31_in_space(&mut lines, law);
        let mut lines = q15(self.0, law);
        let law = Fixed16(law);
        lines.value("pdf_solid_angle", |x| law.pdf_solid_angle(x));
        lines.sample(|rng| law.sample(rng));
        lines.draws("point", |rng| law.sample_point(short_units(), rng));
        let normal = [0x4ccd, 0, -0x6666].map(I1F15::from_bits);
        lines.draws("sample_around", |rng| law.sample_around(normal, rng));
        lines.warped(|u| law.warp_direction(u));
        lines.self_test(self_test::fixed(law));
    }

    fn power(&mut self, law: CosPower) {
        q31_in_space(&mut q31(self.0, law), law);
    }
}
