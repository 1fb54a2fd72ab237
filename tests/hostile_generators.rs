//! Promise: bounded work, whatever the generator.
//!
//! Stuck and hostile generators: every sampler ends, draws its documented words and keeps its
//! promises.

use coslobe::{CosSin, Law, Measure, Planar, Radius, Spatial, Tails, uniform};
use kit::catalogue::{every_law, every_number};
use kit::stats::claim::Claim;
use kit::stats::words::{Source, Words, hostile};
use kit::{Drawn, Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw, TangentLaw};

/// Words of a direction in space.
fn in_space<T: Number>(law: Id) -> Drawn {
    plus(T::theta_words(law), T::TURN_WORDS)
}

fn plus(a: Drawn, b: Drawn) -> Drawn {
    (a.0 + b.0, a.1 + b.1)
}

/// Enough draws for any of the sources to come round in every role.
const ROUNDS: usize = 24;

/// Draws from every generator and checks the count of words; `check` sees each value.
fn drawn<V>(
    case: &str,
    expected: Drawn,
    draw: impl Fn(&mut Words<Source>) -> V,
    check: impl Fn(&str, V),
) {
    for (name, source) in hostile() {
        let case = format!("{case} from {name}");
        let mut words = Words::new(source);
        for _ in 0..ROUNDS {
            words.drawn = (0, 0);
            let value = draw(&mut words);
            assert_eq!(words.drawn, expected, "{case}: words (u32, u64)");
            check(&case, value);
        }
    }
}

fn norm<const N: usize>(v: [f64; N]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// A unit vector to 2 ulp or what the type promises, inside the open support where `law` has a
/// positive finite density.
fn direction<T: Number>(case: &str, law: &impl Law<T>, at: CosSin<T>, length: f64) {
    let zero = T::of(0.0);
    assert!(
        (length - 1.0).abs() <= T::LENGTH,
        "{case}: length 1 + {:e}",
        length - 1.0
    );
    assert!(at.cos > zero, "{case}: cos = {:?}", at.cos);
    let density = law.density(at).into();
    assert!(
        density > 0.0 && density.is_finite(),
        "{case}: density {density:e} at {at:?}"
    );
    let pdf = law.pdf(T::of(at.sin.into().atan2(at.cos.into()))).into();
    assert!(
        pdf >= 0.0 && pdf.is_finite(),
        "{case}: pdf {pdf:e} at {at:?}"
    );
}

struct Hostile;

impl Hostile {
    fn spatial<T: Number>(name: &str, words: Drawn, law: &impl Spatial<T>) {
        let check = |case: &str, d: [T; 3]| {
            let [x, y, z] = d.map(Into::into);
            let sin = T::of(x.hypot(z));
            direction(case, law, CosSin { cos: d[1], sin }, norm([x, y, z]));
        };
        drawn(
            &format!("{name} sample"),
            words,
            |rng| Spatial::sample(law, rng),
            check,
        );
        let half = 0.5f64.sqrt();
        let up = [0.0, 1.0, 0.0];
        for normal in [up, [0.0, 0.0, -1.0], [half, 0.0, -half], [-0.6, 0.0, 0.8]] {
            let case = format!("{name} sample_around {normal:?}");
            let draw = |rng: &mut Words<Source>| law.sample_around(normal.map(T::of), rng);
            drawn(&case, words, draw, |case, d| {
                let d = d.map(Into::into);
                // The frame adds 4 ulp to the sample's own error, the normal its own rounding.
                let slack = T::LENGTH + 6.0 * T::EPSILON;
                assert!((norm(d) - 1.0).abs() <= slack, "{case}: {d:?}");
                let cos: f64 = d.iter().zip(normal).map(|(a, b)| a * b).sum();
                assert!(cos > -8.0 * T::EPSILON, "{case}: {d:?} lies below");
            });
        }
    }

    fn points<T: Number, const N: usize>(
        name: &str,
        measure: Measure,
        sample: Drawn,
        draw: impl Fn(Radius<T>, &mut Words<Source>) -> [T; N],
    ) {
        let share = match measure {
            Measure::Area | Measure::Volume => T::TAIL_WORDS,
            _ => (0, 0),
        };
        let largest = T::of(T::LARGEST.into() * 0.25);
        for rho in [T::SMALLEST, T::of(1.0), largest] {
            let radius = Radius::new(rho).expect("inside the documented range");
            let case = format!("{name} sample_point rho={rho:?}");
            drawn(
                &case,
                plus(sample, share),
                |rng| draw(radius, rng),
                |case, point| {
                    // In f64 the norm of the largest point would overflow without the division.
                    let unit = point.map(|c| c.into() / rho.into());
                    let slack = 4.0 * T::LENGTH;
                    assert!(
                        norm(unit) <= 2.0 + slack && unit[1] >= 0.0,
                        "{case}: {point:?}"
                    );
                },
            );
        }
    }
}

impl<T: Number> LawVisitor<T> for Hostile {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        let words = T::theta_words(id);
        let sample = |rng: &mut Words<Source>| Planar::sample(&law, rng);
        drawn(
            &format!("{} sample", claim.name),
            words,
            sample,
            |case, [sin, cos]| {
                direction(
                    case,
                    &law,
                    CosSin { cos, sin },
                    norm([sin.into(), cos.into()]),
                );
            },
        );
        Self::points(&claim.name, L::MEASURE, words, |rho, rng| {
            law.sample_point(rho, rng)
        });
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        Self::spatial(&claim.name, in_space::<T>(id), &law);
    }

    fn tangent<L: TangentLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        let words = in_space::<T>(id);
        Self::spatial(&claim.name, words, &law);
        Self::points(&claim.name, L::MEASURE, words, |rho, rng| {
            law.sample_point(rho, rng)
        });
    }
}

fn uniforms<T: Number>() {
    let inside = |case: &str, u: T| {
        assert!(u.into() > 0.0 && u.into() <= 1.0, "{case}: {u:?}");
    };
    drawn(
        "uniform::unit",
        T::TAIL_WORDS,
        |rng| uniform::unit::<T, _>(rng),
        inside,
    );
    drawn(
        "uniform::tails",
        T::TAIL_WORDS,
        |rng| uniform::tails(rng),
        |case, p: Tails<T>| {
            inside(case, p.lower());
            inside(case, p.upper());
        },
    );
    drawn(
        "uniform::azimuth",
        T::TURN_WORDS,
        |rng| uniform::azimuth(rng),
        |case, at: CosSin<T>| {
            let length = norm([at.cos.into(), at.sin.into()]);
            assert!((length - 1.0).abs() <= T::LENGTH, "{case}: {at:?}");
        },
    );
}

const F32_EXPONENTS: [f64; 7] = [0.0, 1e-30, 0.5, 7.3, 1e4, 1e12, f32::MAX as f64];
const F64_EXPONENTS: [f64; 7] = [0.0, 1e-300, 0.5, 7.3, 1e4, 1e12, f64::MAX];

impl NumberVisitor for Hostile {
    fn number<T: Number>(&mut self) {
        let single = size_of::<T>() == 4;
        uniforms::<T>();
        every_law::<T>(
            self,
            if single {
                &F32_EXPONENTS
            } else {
                &F64_EXPONENTS
            },
        );
    }
}

#[test]
fn hostile_generators() {
    every_number(&mut Hostile);
}
