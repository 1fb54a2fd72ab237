//! Spheres over planes, circles over lines: what arrives from a lamp, by every strategy.

use crate::mutants::{Askew, Plain, Spoiled};
use crate::stage::{agrees, camera, diffuse, lamp, level, material, shoot};
use shade_core::effect::Combine;
use shade_core::{AnyPlanar, AnySpatial, Sampling, Scene, Vector};
use std::f64::consts::PI;

const STRATEGIES: [Combine; 4] = [
    Combine::Balance,
    Combine::Power,
    Combine::Light,
    Combine::Scatter,
];

/// The origin of a level plate of albedo 0.8, seen from beside a lamp of radius `r` and radiance 3
/// at `centre`.
fn plate<V: Vector>(own: V::Law, centre: &[f64], r: f64, combine: Combine) -> Scene<V> {
    let s = 0.5f64.sqrt();
    let mut scene = Scene::new(camera(&[-0.1, 0.1, 0.0], &[s, -s, 0.0]));
    let white = material(&mut scene, diffuse(own, 0.8));
    scene
        .plates
        .push(level(0.0, [-1.0; 2], [1.0; 2], white))
        .expect("room");
    scene.lamps.push(lamp(centre, r, 3.0)).expect("room");
    scene.combine = combine;
    scene
}

/// Irradiance π L (R/d)² cos θ: the plate reflects 0.8 · 3 · (R/d)² cos θ.
fn space<V: Vector<T = f64>>(
    own: V::Law,
    law: &impl Sampling<V>,
    combine: Combine,
) -> Result<(), String> {
    let overhead = shoot(&plate(own, &[0.0, 2.0, 0.0], 1.2, combine), law, 1 << 15);
    agrees(&overhead, 2.4 * 0.36)?;
    let tilted = shoot(&plate(own, &[1.2, 1.6, 0.0], 0.8, combine), law, 1 << 15);
    agrees(&tilted, 2.4 * 0.16 * 0.8)
}

#[test]
fn sphere_over_plane() {
    for combine in STRATEGIES {
        assert_eq!(
            space::<[f64; 3]>(AnySpatial::Lambert, &AnySpatial::Lambert, combine),
            Ok(())
        );
        assert_eq!(space(AnySpatial::Lambert, &Spoiled::Sound, combine), Ok(()));
    }
}

#[test]
fn planted_measure_and_density_are_caught() {
    assert!(space::<Askew>(Plain, &Plain, Combine::Light).is_err());
    assert!(space::<Askew>(Plain, &Plain, Combine::Balance).is_err());
    for combine in [Combine::Balance, Combine::Power] {
        assert!(space(AnySpatial::Lambert, &Spoiled::WrongDensity, combine).is_err());
    }
    assert!(
        space(
            AnySpatial::Lambert,
            &Spoiled::WrongExponent,
            Combine::Scatter
        )
        .is_err()
    );
    assert!(
        space(
            AnySpatial::Lambert,
            &Spoiled::CosineDropped,
            Combine::Scatter
        )
        .is_err()
    );
}

/// In flatland the irradiance is 2 L (R/d) cos θ, and what is reflected a L (R/d) cos θ. A probe
/// above the plate's middle sees that, the lamp itself and the sky, so a narrow view is taken: a
/// pixel cannot. What a probe sees of a lamp alone is L α/π.
#[test]
fn circle_seen_by_a_probe() {
    for combine in STRATEGIES {
        let mut scene = Scene::<[f64; 2]>::new(camera(&[0.3, -0.4], &[0.0, 0.0]));
        scene.lamps.push(lamp(&[0.3, 1.6], 1.2, 3.0)).expect("room");
        scene.combine = combine;
        let alpha = (1.2f64 / 2.0).asin();
        let pixel = shoot(&scene, &AnyPlanar::CircleShell, 1 << 15);
        assert_eq!(agrees(&pixel, 3.0 * alpha / PI), Ok(()));
        assert!(
            agrees(&pixel, 3.0 * 0.6 / PI).is_err(),
            "the sine for the angle"
        );
    }
}

/// A probe in a hollow circle of albedo a around a lamp of the same centre: the wall's radiance is
/// B = a L F/(1 − a (1 − F)) with the flat form factor F = r/R from the wall to the lamp.
#[test]
fn lamp_in_a_hollow_circle() {
    use crate::stage::sphere;
    for combine in STRATEGIES {
        let (r, wide, a, l) = (0.5, 2.0, 0.6, 3.0);
        let mut scene = Scene::<[f64; 2]>::new(camera(&[0.0, 1.0], &[0.0, 0.0]));
        let wall = material(&mut scene, diffuse(AnyPlanar::CircleShell, a));
        scene
            .spheres
            .push(sphere(&[0.0; 2], wide, wall))
            .expect("room");
        scene.lamps.push(lamp(&[0.0, 0.0], r, l)).expect("room");
        scene.bounces = 40;
        scene.combine = combine;
        let f = r / wide;
        let b = a * l * f / (1.0 - a * (1.0 - f));
        // The probe at distance 1 sees the lamp under asin(½) to each side, and else the wall.
        let share = (0.5f64).asin() / PI;
        let pixel = shoot(&scene, &AnyPlanar::CircleShell, 1 << 13);
        assert_eq!(agrees(&pixel, l * share + b * (1.0 - share)), Ok(()));
        let without_cos = a * l * 2.0 * (r / wide).asin() / PI;
        assert!(agrees(&pixel, l * share + without_cos * (1.0 - share)).is_err());
    }
}
