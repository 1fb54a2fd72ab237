//! Every law as the density of diffuse directions: the same image, at the predicted variance.

use crate::stage::{agrees, camera, diffuse, exponent, grey, lamp, level, material, shoot};
use coslobe::CosPower;
use shade_core::effect::{Combine, Sky};
use shade_core::{AnyPlanar, AnySpatial, LawName, Pixel, Scene};
use std::f64::consts::PI;

/// A white plate under a sky of 1: a sample is the law's `lambert_weight`.
fn under_sky(law: &AnySpatial<f64>, samples: u32, seed: u32) -> Pixel<f64> {
    let mut scene = Scene::<[f64; 3]>::new(camera(&[0.0, 1.0, 0.0], &[0.0, -1.0, 0.0]));
    let white = material(&mut scene, diffuse(AnySpatial::Lambert, 1.0));
    scene
        .plates
        .push(level(0.0, [-1.0; 2], [1.0; 2], white))
        .expect("room");
    scene.sky = Sky {
        nadir: grey(1.0),
        zenith: grey(1.0),
    };
    scene.seed = seed;
    shoot(&scene, law, samples)
}

/// E[w²] − 1 with w = 2/((k+1) cosᵏ⁻¹θ): (k−1)²/((k+1)(3−k)) for k < 3.
fn predicted(k: f64) -> f64 {
    (k - 1.0) * (k - 1.0) / ((k + 1.0) * (3.0 - k))
}

fn has_variance(law: &AnySpatial<f64>, want: f64) -> Result<(), String> {
    let pixel = under_sky(law, 1 << 18, 0);
    agrees(&pixel, 1.0)?;
    let have = pixel.variance()[0];
    // At k = 2 the squared weights have no variance: of n samples the least cosine is about n^−⅓,
    // beyond which 4/3 n^−⅓ of the variance, 6 % here, is hardly ever found.
    if (have - want).abs() <= 0.1 * want {
        Ok(())
    } else {
        Err(format!("variance {have}; expected {want}"))
    }
}

#[test]
fn variances_in_space() {
    let power = |k| AnySpatial::Power(CosPower::new(k).expect("finite"));
    let named = LawName::SPATIAL.map(|name| AnySpatial::named(name, 0.5).expect("of space"));
    for law in named.into_iter().chain([0.0, 1.5].map(power)) {
        let k = exponent(&law);
        if k < 3.0 {
            assert_eq!(has_variance(&law, predicted(k)), Ok(()), "{law:?}");
        }
    }
    assert!(has_variance(&power(1.5), predicted(2.0)).is_err());
    assert!(has_variance(&power(0.5), predicted(0.0)).is_err());
}

/// In the plane w = (cos θ/2)/p: ⟨w²⟩ = π²/8 for `CircleArc` as for `Disk`. A floor line under a
/// sky cannot be seen alone by a probe, so a hollow circle that shines is: what it reflects, first
/// bounce.
#[test]
fn variances_in_flatland() {
    let seen = |law: &dyn Fn(&Scene<[f64; 2]>) -> Pixel<f64>| {
        use crate::stage::sphere;
        use shade_core::Material;
        let mut scene = Scene::<[f64; 2]>::new(camera(&[0.1, 0.2], &[0.0, 0.0]));
        let wall = Material::new(grey(1.0), grey(0.0), AnyPlanar::CircleShell, grey(1.0));
        let wall = material(&mut scene, wall);
        scene
            .spheres
            .push(sphere(&[0.0; 2], 1.0, wall))
            .expect("room");
        law(&scene)
    };
    // 1 of the wall that the probe sees, and w of the wall that lights it.
    let check = |pixel: Pixel<f64>, want: f64| {
        agrees(&pixel, 2.0)?;
        let have = pixel.variance()[0];
        if (have - want).abs() <= 0.06 * want + 1e-12 {
            Ok(())
        } else {
            Err(format!("variance {have}; expected {want}"))
        }
    };
    let same = PI * PI / 8.0 - 1.0;
    let arc = seen(&|scene| shoot(scene, &AnyPlanar::CircleArc, 1 << 17));
    let disk = seen(&|scene| shoot(scene, &AnyPlanar::Disk, 1 << 17));
    let shell = seen(&|scene| shoot(scene, &AnyPlanar::CircleShell, 1 << 10));
    assert_eq!(check(arc, same), Ok(()));
    assert_eq!(check(disk, same), Ok(()));
    assert_eq!(check(shell, 0.0), Ok(()));
    assert!(check(arc, 1.2 * same).is_err());
}

fn median(mut x: Vec<f64>) -> f64 {
    x.sort_by(f64::total_cmp);
    x[x.len() / 2]
}

/// `Ball` for a diffuse surface: w = 1/(2 cos²θ) and p = 4 cos³θ in cos θ, so ⟨w²⟩ = ∫ dc/c has no
/// end. Of n samples the least cosine is about n^−¼, up to which the integral is ¼ ln n: sixteen
/// times as many samples add ln 2 to the variance that is found, for ever.
#[test]
fn the_variance_of_ball_grows_for_ever() {
    let found = |n: u32| {
        median(
            (0..25)
                .map(|seed| under_sky(&AnySpatial::Ball, n, seed).variance()[0])
                .collect(),
        )
    };
    let growth = [1 << 8, 1 << 12, 1 << 16].map(found);
    for pair in growth.windows(2) {
        let step = pair[1] - pair[0];
        assert!((step - 2f64.ln()).abs() < 0.25, "{growth:?}");
    }
    // A finite variance stands still.
    let tame = [1 << 8, 1 << 16].map(|n| {
        median(
            (0..25)
                .map(|seed| {
                    under_sky(&AnySpatial::Power(CosPower::new(0.5).expect("½")), n, seed)
                        .variance()[0]
                })
                .collect(),
        )
    });
    assert!((tame[1] - tame[0]).abs() < 0.05);
}

/// A lamp that sets: half of it below the horizon, where `Ball` hardly ever looks and weighs most.
fn at_the_horizon(law: &AnySpatial<f64>, combine: Combine, n: u32, seed: u32) -> Pixel<f64> {
    let mut scene = Scene::<[f64; 3]>::new(camera(&[0.0, 1.0, 0.0], &[0.0, -1.0, 0.0]));
    let white = material(&mut scene, diffuse(AnySpatial::Lambert, 1.0));
    scene
        .plates
        .push(level(0.0, [-0.5; 2], [0.5; 2], white))
        .expect("room");
    scene
        .lamps
        .push(lamp(&[3.0, 0.0, 0.0], 1.5, 1.0))
        .expect("room");
    (scene.combine, scene.seed) = (combine, seed);
    shoot(&scene, law, n)
}

#[test]
fn combining_tames_ball() {
    // Half the disc sin α = ½ upright: its foot on the plate is a thin crescent; all agree on what
    // it is.
    let want = at_the_horizon(&AnySpatial::Lambert, Combine::Balance, 1 << 18, 1).mean()[0];
    for combine in [Combine::Balance, Combine::Power, Combine::Light] {
        let pixel = at_the_horizon(&AnySpatial::Ball, combine, 1 << 14, 2);
        assert!((pixel.mean()[0] / want - 1.0).abs() < 0.05, "{combine:?}");
    }
    let found = |combine| {
        median(
            (0..9)
                .map(|s| at_the_horizon(&AnySpatial::Ball, combine, 1 << 14, s).variance()[0])
                .collect(),
        )
    };
    let (alone, both) = (found(Combine::Scatter), found(Combine::Balance));
    assert!(alone > 10.0 * both, "alone {alone}, combined {both}");
    let many = |combine| {
        median(
            (0..5)
                .map(|s| at_the_horizon(&AnySpatial::Ball, combine, 1 << 17, s).variance()[0])
                .collect(),
        )
    };
    assert!((many(Combine::Balance) / both - 1.0).abs() < 0.1);
}
