//! The tiers beside each other: `Precise` draws what the plain type draws.

use coslobe::{PlanarPoint, Precise, Spatial};
use kit::stats::laws::{Claim, Float, Visitor, each};
use kit::stats::words;

/// Directions of `T` and of its `Precise`, from the same words.
struct Same<T>(Vec<(String, Vec<[T; 3]>)>);

impl<T: Float> Visitor<T> for Same<T> {
    fn planar<L: PlanarPoint<T> + Copy + 'static>(&mut self, claim: Claim, law: L) {
        let mut rng = words::pcg("tiers");
        let draw = |_| {
            let [x, y] = law.sample(&mut rng);
            [x, y, T::of(0.0)]
        };
        self.0.push((claim.name, (0..N).map(draw).collect()));
    }
    fn spatial<L: Spatial<T> + Copy + 'static>(&mut self, claim: Claim, law: L) {
        let mut rng = words::pcg("tiers");
        let draw = |_| Spatial::sample(&law, &mut rng);
        self.0.push((claim.name, (0..N).map(draw).collect()));
    }
}

const N: usize = 20_000;
const EXPONENTS: [f64; 3] = [0.5, 7.3, 1e4];

/// The plain bounds are 4 ulp for each of the two factors of a component, and one rounding.
fn precise_draws_the_same<T: Float>()
where
    Precise<T>: Float,
{
    let (mut plain, mut precise) = (Same::<T>(Vec::new()), Same::<Precise<T>>(Vec::new()));
    each(&mut plain, &EXPONENTS);
    each(&mut precise, &EXPONENTS);
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
