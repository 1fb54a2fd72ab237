//! Samplers, fed by any generator.

use super::input::Words;
use super::measure::{assert_unit, context};
use coslobe::{CosSin, Planar, Spatial};
use kit::catalogue::{every_law, every_number};
use kit::{Drawn, Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};

/// The promise: a unit vector to 2 ulp of 1 (or what stands for it).
const UNIT_ULP: f64 = 2.0;

/// Words of a direction in space.
pub(super) fn of_direction<T: Number>() -> Drawn {
    let (tail, turn) = (T::TAIL_WORDS, T::TURN_WORDS);
    (tail.0 + turn.0, tail.1 + turn.1)
}

/// The whole input is the generator.
pub fn check(data: &[u8]) {
    every_number(&mut Check(data));
}

struct Check<'a>(&'a [u8]);

impl NumberVisitor for Check<'_> {
    fn number<T: Number>(&mut self) {
        all::<T>(self.0);
    }
}

fn all<T: Number>(data: &[u8]) {
    let exponents = [0.0, 1e-30, 0.5, 20.0, 1e6, T::LARGEST.wide()];
    every_law::<T>(&mut Fed(data), &exponents);
}

struct Fed<'a>(&'a [u8]);

impl<T: Number> LawVisitor<T> for Fed<'_> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        planar(&law, self.0);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        spatial(&law, self.0);
    }
}

/// Draws enough in a row to come round the input, so that every alignment is met.
fn rounds(data: &[u8]) -> usize {
    data.len().clamp(1, 16)
}

fn planar<T: Number, L: Planar<T>>(law: &L, data: &[u8]) {
    let _context = context::<T, L>();
    let mut words = Words::new(data);
    for _ in 0..rounds(data) {
        words.drawn = (0, 0);
        let d = Planar::sample(law, &mut words);
        assert_eq!(words.drawn, T::TAIL_WORDS, "words drawn");
        assert_unit(d, UNIT_ULP);
        let [sin, cos] = d;
        assert_open(law.density(CosSin { cos, sin }), d, cos);
    }
}

pub fn spatial<T: Number, L: Spatial<T>>(law: &L, data: &[u8]) {
    let _context = context::<T, L>();
    let mut words = Words::new(data);
    for _ in 0..rounds(data) {
        words.drawn = (0, 0);
        let d = Spatial::sample(law, &mut words);
        assert_eq!(words.drawn, of_direction::<T>(), "words drawn");
        assert_unit(d, UNIT_ULP);
        let [x, cos, z] = d;
        // hypot of squares that may underflow in T: taken in f64, where only T = f64 can.
        let sin = T::of(x.wide().hypot(z.wide()));
        assert!(sin.wide() > 0.0, "{d:?} lies on the axis");
        assert_open(law.density(CosSin { cos, sin }), d, cos);
    }
}

/// Inside the open support, with a density that an estimator can divide by.
fn assert_open<T: Number, const N: usize>(density: T, d: [T; N], cos: T) {
    assert!(cos.wide() > 0.0, "{d:?} is not above the horizon");
    let positive = density.wide() > 0.0 && density.wide() < f64::INFINITY;
    assert!(positive, "density {density:?} at {d:?}");
}
