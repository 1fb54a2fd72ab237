//! `Distribution`: the bits of the samplers.

use crate::generator;
use ::rand::RngExt;
use ::rand::distr::Distribution;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Lambert, Planar, Real, Spatial, SphereShell,
};
use kit::catalogue::every_number;
use kit::{Number, NumberVisitor};

/// With `Distribution`, `Planar` and `Spatial` all in scope this has to compile.
#[test]
fn sample_is_not_ambiguous() {
    let expected: [f32; 3] = Spatial::sample(&Ball, &mut generator());
    let inherent: [f32; 3] = Ball.sample(&mut generator());
    let through_rng: [f32; 3] = generator().sample(Ball);
    assert_eq!([inherent, through_rng], [expected; 2]);

    let expected: [f64; 2] = Planar::sample(&Disk, &mut generator());
    let inherent: [f64; 2] = Disk.sample(&mut generator());
    let through_rng: [f64; 2] = generator().sample(Disk);
    assert_eq!([inherent, through_rng], [expected; 2]);
}

fn planar<T: Real, L: Planar<T> + Distribution<[T; 2]> + Copy>(law: L) {
    let (mut a, mut b) = (generator(), generator());
    for _ in 0..100 {
        assert_eq!(Planar::sample(&law, &mut a), b.sample(law));
    }
    assert_eq!(a, b, "different words drawn");
}

fn spatial<T: Real, L: Spatial<T> + Distribution<[T; 3]> + Copy>(law: L) {
    let (mut a, mut b) = (generator(), generator());
    for _ in 0..100 {
        assert_eq!(Spatial::sample(&law, &mut a), b.sample(law));
    }
    assert_eq!(a, b, "different words drawn");
}

fn every_law<T: Real>(lobe: CosPower<T>) {
    planar::<T, _>(Disk);
    planar::<T, _>(CircleShell);
    planar::<T, _>(CircleArc);
    spatial::<T, _>(Ball);
    spatial::<T, _>(SphereShell);
    spatial::<T, _>(Lambert);
    spatial(lobe);
}

#[test]
fn a_distribution_has_the_bits_of_its_sampler() {
    struct Types;
    impl NumberVisitor for Types {
        fn number<T: Number>(&mut self) {
            every_law(CosPower::new(T::of(7.5)).unwrap());
        }
    }
    every_number(&mut Types);
}
