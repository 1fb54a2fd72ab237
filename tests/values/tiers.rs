//! The tiers beside each other: `Precise` draws what the plain type draws.

use coslobe::{Precise, Spatial};
use kit::catalogue::every_law;
use kit::stats::claim::Claim;
use kit::stats::words;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};

/// Directions of `T` and of its `Precise`, from the same words.
struct Same<T>(Vec<(String, Vec<[T; 3]>)>);

impl<T: Number> LawVisitor<T> for Same<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        let mut rng = words::pcg("tiers");
        let draw = |_| {
            let [x, y] = law.sample(&mut rng);
            [x, y, T::of(0.0)]
        };
        self.0.push((claim.name, (0..N).map(draw).collect()));
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        let mut rng = words::pcg("tiers");
        let draw = |_| Spatial::sample(&law, &mut rng);
        self.0.push((claim.name, (0..N).map(draw).collect()));
    }
}

const N: usize = 20_000;
const EXPONENTS: [f64; 3] = [0.5, 7.3, 1e4];

/// The plain bounds are 4 ulp for each of the two factors of a component, and one rounding.
fn precise_draws_the_same<T: Number>()
where
    Precise<T>: Number,
{
    let (mut plain, mut precise) = (Same::<T>(Vec::new()), Same::<Precise<T>>(Vec::new()));
    every_law(&mut plain, &EXPONENTS);
    every_law(&mut precise, &EXPONENTS);
    for ((name, a), (_, b)) in plain.0.into_iter().zip(precise.0) {
        for (a, b) in a.into_iter().zip(b) {
            for (a, b) in a.into_iter().zip(b) {
                let (a, b): (f64, f64) = (a.into(), b.into());
                assert!(
                    (a - b).abs() <= 9.0 * T::EPSILON * b.abs(),
                    "{name}: {a:e} and {b:e}"
                );
            }
        }
    }
}

#[test]
fn precise_draws_the_same_f32() {
    precise_draws_the_same::<f32>();
}

#[test]
fn precise_draws_the_same_f64() {
    precise_draws_the_same::<f64>();
}
