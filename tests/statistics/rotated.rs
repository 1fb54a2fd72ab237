//! Lobes around a normal in integers, turned back into the axes of the law.

use coslobe::integers::CosPower;
use coslobe::{Ball, Fixed, Fixed16, Frame, Lambert};
use fixed::types::{I1F15, I1F31, U16F16};
use kit::Id;
use kit::catalogue::moments;
use kit::integer::{Format, Long, Short, direction};
use kit::stats::claim::{Claim, Direction};
use kit::stats::harness::examine;
use kit::stats::words;
use rand_pcg::Pcg64;

const N: usize = 400_000;

/// Three roundings, and a normal that is a unit vector to half a unit a component.
fn claim<F: Format>(id: Id) -> Claim {
    let moments = moments::<f64>(id).expect("an exponent");
    let claim = F::claim(&id.to_string(), false, id.exponent(), moments);
    let off = 12.0 * F::UNIT;
    Claim {
        length: off,
        error: off,
        grid: 16.0 * F::UNIT,
        ..claim
    }
}

/// What is below the surface by rounding counts as on it.
fn check<F: Format, C: Copy + Into<f64>>(
    id: Id,
    n: usize,
    from: impl Fn(f64) -> C,
    draw: impl Fn([C; 3], &mut Pcg64) -> [C; 3],
) {
    for normal in [[0.36, -0.48, 0.8], [0.48, 0.6, -0.64], [0.0, 0.0, -1.0]] {
        let normal = normal.map(&from);
        let unit = direction(&normal);
        let length = unit.map(|c| c * c).iter().sum::<f64>().sqrt();
        let axes = Frame::from_unit(unit.map(|c| c / length)).axes();
        let mut rng = words::pcg(&id.to_string());
        let unrotated = || -> Direction {
            let world = direction(&draw(normal, &mut rng));
            let [x, y, z] = axes.map(|axis| (0..3).map(|i| axis[i] * world[i]).sum::<f64>());
            [x, y.max(F::UNIT), z]
        };
        examine(&claim::<F>(id), n, unrotated)
            .without("ties")
            .accepted();
    }
}

#[test]
fn rotated_lobes_keep_their_law() {
    let long = I1F31::saturating_from_num::<f64>;
    check::<Long, _>(Id::Lambert, N, long, |n, rng| {
        Fixed(Lambert).sample_around(n, rng)
    });
    check::<Long, _>(Id::Ball, N, long, |n, rng| {
        Fixed(Ball).sample_around(n, rng)
    });
    let power = Fixed(CosPower::new(U16F16::from_num(20)));
    check::<Long, _>(Id::CosPower(20.0), N, long, |n, rng| {
        power.sample_around(n, rng)
    });
    // Of more samples the rounding of a cosine to a grid of 2⁻¹⁵ shows.
    let short = I1F15::saturating_from_num::<f64>;
    check::<Short, _>(Id::Lambert, N / 40, short, |n, rng| {
        Fixed16(Lambert).sample_around(n, rng)
    });
    check::<Short, _>(Id::Ball, N / 40, short, |n, rng| {
        Fixed16(Ball).sample_around(n, rng)
    });
}
