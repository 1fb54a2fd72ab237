//! Points of `Precise`: cos θ, r, the direction's component and their product are each rounded, so
//! that the point of the words drawn is off by at most 3 ulp (f64: 3.25, since three of them are
//! within 0.55).

use crate::precise_directions::{Fine, Words, azimuth, components, drawn_tail, error};
use coslobe::uniform::{self, TailBits, TurnBits};
use coslobe::{Ball, Lambert, Precise, Radius, SpatialPoint};
use kit::accuracy::reference::Id;
use kit::accuracy::wide::Wide;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// The words of a sample, in the order that it draws them.
trait Drawn: Words {
    fn drawn(rng: &mut Pcg64) -> (TailBits<Self>, TurnBits<Self>);
}

impl Drawn for Precise<f32> {
    fn drawn(rng: &mut Pcg64) -> (u64, u32) {
        (rng.next_u64(), rng.next_u32())
    }
}

impl Drawn for Precise<f64> {
    fn drawn(rng: &mut Pcg64) -> (u128, u64) {
        let high = u128::from(rng.next_u64()) << 64;
        (high | u128::from(rng.next_u64()), rng.next_u64())
    }
}

/// The worst of the points of n samples, each with a radius of its own.
fn worst<T: Drawn>(id: Id, law: impl SpatialPoint<T>, n: u32) -> f64 {
    let mut rng = Pcg64::seed_from_u64(41);
    let mut worst = 0.0f64;
    for _ in 0..n {
        let rho = T::of(1.0 + (rng.next_u64() >> 11) as f64 * 2f64.powi(-53));
        let radius = Radius::new(rho).expect("a radius");
        let mut again = rng.clone();
        let got = law.sample_point(radius, &mut rng);
        let (theta, phi) = T::drawn(&mut again);
        let (drawn, nearer, upper) = drawn_tail::<T>(id, theta);
        let (hi, lo) = T::turn(phi);
        let direction = components(drawn, nearer.wide(), upper, azimuth::<Fine<T>>(hi, lo));
        let mut r = Fine::<T>::of(2.0 * rho.wide()) * direction[1];
        if id == Id::Ball {
            r = r * Fine::<T>::of(uniform::unit::<T, _>(&mut again).wide()).cube_root();
        }
        for i in 0..3 {
            worst = worst.max(error(got[i], r * direction[i]));
        }
    }
    println!("{id:?} {}: {worst:.4} ulp", T::NAME);
    worst
}

#[test]
fn points_are_rounded_four_times() {
    let f32s = [
        worst::<Precise<f32>>(Id::Ball, Ball, 100_000),
        worst::<Precise<f32>>(Id::Lambert, Lambert, 100_000),
    ];
    let f64s = [
        worst::<Precise<f64>>(Id::Ball, Ball, 20_000),
        worst::<Precise<f64>>(Id::Lambert, Lambert, 20_000),
    ];
    // What one rounding less would keep to is exceeded.
    for (worst, bound) in [(f32s, 3.0), (f64s, 3.25)] {
        let worst = worst[0].max(worst[1]);
        assert!((2.0..=bound).contains(&worst), "{worst}");
    }
}
