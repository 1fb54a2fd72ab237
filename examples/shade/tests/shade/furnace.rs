//! Energy: what goes in comes out.

use crate::mutants::Spoiled;
use crate::stage::{
    agrees, camera, diffuse, exponent, grey, is_exactly, lamp, level, material, shoot, sphere,
};
use shade_core::effect::Sky;
use shade_core::{
    AnyPlanar, AnySpatial, LawName, Material, Number, NumberVisitor, Scene, Vector, every_number,
};

/// A ball of albedo ½ under a sky of 1.
fn ball<T: Number>() -> Scene<[T; 3]> {
    let mut scene = Scene::new(camera(&[0.3, 0.2, 5.0], &[0.0, 0.0, -1.0]));
    let half = material(&mut scene, diffuse(AnySpatial::Lambert, 0.5));
    scene
        .spheres
        .push(sphere(&[0.0; 3], 1.0, half))
        .expect("room");
    scene.sky = Sky {
        nadir: grey(1.0),
        zenith: grey(1.0),
    };
    scene
}

#[test]
fn albedo_without_variance() {
    struct Exact;
    impl NumberVisitor for Exact {
        fn number<T: Number>(&mut self) {
            let pixel = shoot(&ball::<T>(), &AnySpatial::Lambert, 256);
            assert_eq!((pixel.mean(), pixel.variance()), ([0.5; 3], [0.0; 3]));
        }
    }
    every_number(&mut Exact);
}

#[test]
fn planted_weights_are_caught() {
    let check = |law| {
        // A graded sky: under a constant one a wrong law with weight 1 is as white.
        let mut scene = ball::<f64>();
        scene.sky.nadir = grey(0.0);
        scene.camera = camera(&[0.0, 5.0, 0.0], &[0.0, -1.0, 0.0]);
        // ⟨(1 + cos θ)/2⟩ = 5/6.
        agrees(&shoot(&scene, &law, 1 << 16), 0.5 * 5.0 / 6.0)
    };
    assert_eq!(check(Spoiled::Sound), Ok(()));
    assert!(check(Spoiled::CosineDropped).is_err());
    assert!(check(Spoiled::WrongExponent).is_err());
}

/// Inside a hollow sphere of radiance 1 and albedo a: 1 + a + … + aⁿ, in every sample.
#[test]
fn bounces_conserve_energy() {
    fn check<V: Vector>(own: V::Law) {
        for (albedo, bounces) in [(0.5, 1), (0.5, 4), (1.0, 8), (0.9, 32)] {
            let mut scene = Scene::new(camera(&[0.1, 0.2, 0.3], &[0.6, 0.0, 0.8]));
            let wall = Material::new(grey(albedo), grey(0.0), own, grey(1.0));
            let wall = material(&mut scene, wall);
            scene
                .spheres
                .push(sphere(&[0.0; 3], 2.0, wall))
                .expect("room");
            scene.bounces = bounces;
            let want: f64 = (0..=bounces).map(|i| f64::powi(albedo, i.into())).sum();
            assert_eq!(is_exactly(&shoot(&scene, &own, 64), want), Ok(()));
            let too_many = want + f64::powi(albedo, i32::from(bounces) + 1);
            assert!(is_exactly(&shoot(&scene, &own, 64), too_many).is_err());
        }
    }
    check::<[f64; 3]>(AnySpatial::Lambert);
    check::<[f32; 3]>(AnySpatial::Lambert);
    check::<[f64; 2]>(AnyPlanar::CircleShell);
}

/// A plate under a graded sky: level 5/6 of the way from nadir to zenith; upright half-way.
#[test]
fn plate_under_a_graded_sky() {
    let check = |normal: usize, want: f64| {
        let mut towards = [0.0; 3];
        towards[normal] = -1.0;
        let mut eye = [0.0; 3];
        eye[normal] = 1.0;
        let mut scene = Scene::<[f64; 3]>::new(camera(&eye, &towards));
        let white = material(&mut scene, diffuse(AnySpatial::Lambert, 0.8));
        let mut plate = level(0.0, [-1.0; 2], [1.0; 2], white);
        plate.normal = core::array::from_fn(|i| f64::from(i == normal));
        plate.axes = [1, 2].map(|n| core::array::from_fn(|i| f64::from(i == (normal + n) % 3)));
        scene.plates.push(plate).expect("room");
        scene.sky = Sky {
            nadir: grey(0.2),
            zenith: grey(1.4),
        };
        agrees(&shoot(&scene, &AnySpatial::Lambert, 1 << 16), 0.8 * want)
    };
    let along = |height: f64| 0.2 + 1.2 * height;
    assert_eq!(check(1, along(5.0 / 6.0)), Ok(()));
    assert_eq!(check(0, along(0.5)), Ok(()));
    // The uniform hemisphere's mean height is ¾.
    assert!(check(1, along(0.75)).is_err());
}

/// A glossy plate under a sky of 1, seen at an angle: its albedo.
fn glossy(lobe: AnySpatial<f64>, cos: f64) -> shade_core::Pixel<f64> {
    let sin = (1.0 - cos * cos).sqrt();
    let mut scene = Scene::<[f64; 3]>::new(camera(&[sin, cos, 0.0], &[-sin, -cos, 0.0]));
    let gloss = Material::new(grey(0.0), grey(0.9), lobe, grey(0.0));
    let gloss = material(&mut scene, gloss);
    scene
        .plates
        .push(level(0.0, [-1.0; 2], [1.0; 2], gloss))
        .expect("room");
    scene.sky = Sky {
        nadir: grey(1.0),
        zenith: grey(1.0),
    };
    shoot(&scene, &AnySpatial::Lambert, 1 << 16)
}

#[test]
fn gloss_returns_its_reflectance_and_never_more() {
    for name in LawName::SPATIAL {
        let lobe = AnySpatial::named(name, 20.0).expect("a law of space");
        let k = exponent(&lobe);
        let mean_cos = (k + 1.0) / (k + 2.0);
        let var_cos = (k + 1.0) / (k + 3.0) - mean_cos * mean_cos;
        let pixel = glossy(lobe, 1.0);
        assert_eq!(agrees(&pixel, 0.9), Ok(()));
        assert!(agrees(&pixel, 0.9 * mean_cos).is_err(), "⟨cos⟩ forgotten");
        // The weight is 0.9 cos θ/⟨cos⟩.
        let want = 0.81 * var_cos / (mean_cos * mean_cos);
        assert!((pixel.variance()[0] / want - 1.0).abs() < 0.05);
        for cos in [0.9, 0.5, 0.2, 0.02] {
            let albedo = glossy(lobe, cos).mean()[0];
            assert!(albedo < 0.9 && albedo > 0.0, "{lobe:?} {cos}: {albedo}");
        }
    }
}

/// Both parts at once, chosen by chance, under sky and lamp: the sum of each alone.
#[test]
fn parts_of_a_material_add_up() {
    let seen = |d: f64, g: f64| {
        let mut scene = Scene::<[f64; 3]>::new(camera(&[0.6, 0.8, 0.0], &[-0.6, -0.8, 0.0]));
        let both = Material::new(grey(d), grey(g), AnySpatial::Ball, grey(0.0));
        let both = material(&mut scene, both);
        scene
            .plates
            .push(level(0.0, [-1.0; 2], [1.0; 2], both))
            .expect("room");
        scene
            .lamps
            .push(lamp(&[-0.5, 2.0, 0.3], 0.7, 5.0))
            .expect("room");
        scene.sky = Sky {
            nadir: grey(0.0),
            zenith: grey(1.0),
        };
        shoot(&scene, &AnySpatial::Lambert, 1 << 17)
    };
    let (d, g, both) = (seen(0.3, 0.0), seen(0.0, 0.5), seen(0.3, 0.5));
    let sum = d.mean()[0] + g.mean()[0];
    assert!(
        (both.mean()[0] / sum - 1.0).abs() < 0.01,
        "{} and {sum}",
        both.mean()[0]
    );
    assert!((both.mean()[0] / (sum + d.mean()[0]) - 1.0).abs() > 0.1);
}
