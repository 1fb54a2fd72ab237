//! Vectors of samples.

use crate::generator;
use ::heapless::Vec;
use coslobe::integration::heapless::{fill_planar, fill_spatial};
use coslobe::{CircleArc, CosPower, Planar, Spatial};

#[test]
fn fills_what_is_free_with_the_samples_in_order() {
    let (mut a, mut b) = (generator(), generator());
    let mut rays = Vec::<[f32; 2], 16>::new();
    rays.push([9.0, 9.0]).unwrap();
    assert_eq!(fill_planar(&CircleArc, &mut a, &mut rays), 15);
    assert_eq!(rays[0], [9.0, 9.0]);
    for &ray in &rays[1..] {
        let alone: [f32; 2] = Planar::sample(&CircleArc, &mut b);
        assert_eq!(ray, alone);
    }
    assert_eq!(a, b, "a word was drawn for nothing");
    assert_eq!(fill_planar(&CircleArc, &mut a, &mut rays), 0);
    assert_eq!(a, b, "a full vector drew a word");
}

#[test]
fn fills_space_and_nothing() {
    let (mut a, mut b) = (generator(), generator());
    let lobe = CosPower::new(2.5f64).unwrap();
    let mut rays = Vec::<[f64; 3], 5>::new();
    assert_eq!(fill_spatial(&lobe, &mut a, &mut rays), 5);
    for &ray in &rays {
        let alone: [f64; 3] = Spatial::sample(&lobe, &mut b);
        assert_eq!(ray, alone);
    }
    assert_eq!(
        fill_spatial(&lobe, &mut a, &mut Vec::<[f64; 3], 0>::new()),
        0
    );
    assert_eq!(a, b);
}
