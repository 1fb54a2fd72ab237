//! Samplers, fed by any generator.

use super::input::{Input, Words};
use super::measure::{assert_unit, context};
use coslobe::{CosSin, Frame, Planar, Sample, Spatial};
use kit::catalogue::one_law;
use kit::{Drawn, Id, LawVisitor, Number, PlanarLaw, SpatialLaw};

/// The promise: a unit vector to 2 ulp of 1 (or what stands for it).
const UNIT_ULP: f64 = 2.0;

/// Words of a direction in space.
pub(super) fn of_direction<T: Number>(law: Id) -> Drawn {
    let (theta, turn) = (T::theta_words(law), T::TURN_WORDS);
    (theta.0 + turn.0, theta.1 + turn.1)
}

/// One direction, by every way to draw it.
pub(super) fn draws<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    one_law::<T, _>(law, &mut Fed(&input.words));
}

struct Fed<'a>(&'a Words<'a>);

impl<T: Number> LawVisitor<T> for Fed<'_> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        planar(id, &law, self.0);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        spatial(id, &law, self.0);
    }
}

fn planar<T: Number, L: Planar<T>>(id: Id, law: &L, words: &Words) {
    let _context = context::<T, L>();
    let mut rng = words.uncounted();
    let d = Planar::sample(law, &mut rng);
    assert_eq!(rng.drawn, T::theta_words(id), "words drawn");
    assert_unit(d, UNIT_ULP);
    let [sin, cos] = d;
    let at = CosSin { cos, sin };
    assert_open(law.density(at), d, cos);
    let Ok(tried) = Planar::try_sample(law, &mut words.clone());
    assert_eq!(tried, d, "try_sample");
    let density = law.density(at);
    let whole = Planar::sample_with_density(law, &mut words.clone());
    assert_sample(whole, (d, at, density));
}

fn spatial<T: Number, L: Spatial<T>>(id: Id, law: &L, words: &Words) {
    let _context = context::<T, L>();
    let mut rng = words.uncounted();
    let d = Spatial::sample(law, &mut rng);
    assert_eq!(rng.drawn, of_direction::<T>(id), "words drawn");
    assert_unit(d, UNIT_ULP);
    let [x, cos, z] = d;
    // hypot of squares that may underflow in T: taken in f64, where only T = f64 can.
    let sin = T::of(x.wide().hypot(z.wide()));
    assert!(sin.wide() > 0.0, "{d:?} lies on the axis");
    assert_open(law.density(CosSin { cos, sin }), d, cos);
    let Ok(tried) = Spatial::try_sample(law, &mut words.clone());
    assert_eq!(tried, d, "try_sample");

    let s = Spatial::sample_with_density(law, &mut words.clone());
    assert_eq!(s.at.cos, cos, "cos θ of {s:?}");
    assert_unit([s.at.cos, s.at.sin], UNIT_ULP);
    assert_open(s.density, d, s.at.cos);
    assert_sample(s, (d, s.at, law.density(s.at)));
    // Any vector is safe; the direction is turned, and nothing else.
    let normal = [x, -cos, z];
    let turned = Frame::from_unit(normal).to_world(d);
    let around = law.sample_around(normal, &mut words.clone());
    assert_eq!(around, turned, "sample_around {normal:?}");
    let around = law.sample_around_with_density(normal, &mut words.clone());
    assert_sample(around, (turned, s.at, s.density));
}

/// The same bits as by the parts.
#[track_caller]
fn assert_sample<T: Number, const N: usize>(
    s: Sample<T, N>,
    (direction, at, density): ([T; N], CosSin<T>, T),
) {
    assert_eq!((s.direction, s.at, s.density), (direction, at, density));
}

/// Inside the open support, with a density that an estimator can divide by.
fn assert_open<T: Number, const N: usize>(density: T, d: [T; N], cos: T) {
    assert!(cos.wide() > 0.0, "{d:?} is not above the horizon");
    let positive = density.wide() > 0.0 && density.wide() < f64::INFINITY;
    assert!(positive, "density {density:?} at {d:?}");
}
