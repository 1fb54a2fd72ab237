//! Every pixel is a number.

use crate::stage::{camera, diffuse, lamp, level, material};
use shade::file::World;
use shade::random::{Choose, rendered};
use shade_core::{AnyPlanar, Asked, Number, NumberVisitor, Scene, every_number, pixel};

/// Pixels that are none, of the light around a lamp of radius 1 that rests on a floor.
fn beside_a_lamp<T: Number>() -> usize {
    let mut scene = Scene::<[T; 2]>::new(camera(&[0.0, 0.0], &[0.0, 0.0]));
    (scene.camera.width, scene.camera.height) = (64, 48);
    scene.camera.step = T::from_f64(0.1);
    scene.camera.filter = T::from_f64(1.0);
    let floor = material(&mut scene, diffuse(AnyPlanar::CircleShell, 0.8));
    scene
        .plates
        .push(level(-1.0, [-4.0, 0.0], [4.0, 0.0], floor))
        .expect("room");
    scene.lamps.push(lamp(&[0.0, 0.0], 1.0, 1.0)).expect("room");
    let e = Asked(scene.called_for());
    let all = (0..48).flat_map(|y| (0..64).map(move |x| (x, y)));
    let means = all.map(|at| pixel(&scene, e, &AnyPlanar::CircleShell, at, 128, &mut ()).mean());
    means
        .filter(|mean| !mean.iter().all(|x| x.is_finite()))
        .count()
}

#[test]
fn beside_a_lamp_that_rests_on_a_floor() {
    struct Lit;
    impl NumberVisitor for Lit {
        fn number<T: Number>(&mut self) {
            assert_eq!(beside_a_lamp::<T>(), 0, "{}", T::NAME);
        }
    }
    every_number(&mut Lit);
}

/// SplitMix64.
struct Random(u64);

impl Choose for Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((u128::from(z ^ z >> 31) * n as u128) >> 64) as usize
    }
}

#[test]
fn random_scenes() {
    fn check<V: World>() {
        for seed in 0..500 {
            assert_eq!(rendered::<V>(&mut Random(seed), 16), Ok(()), "seed {seed}");
        }
    }
    struct Every;
    impl NumberVisitor for Every {
        fn number<T: Number>(&mut self) {
            check::<[T; 2]>();
            check::<[T; 3]>();
        }
    }
    every_number(&mut Every);
}
