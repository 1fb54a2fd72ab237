//! Hard and soft shadows: umbra, penumbra and full light.

use crate::mutants::{Askew, Plain};
use crate::stage::{agrees, camera, diffuse, grey, is_exactly, lamp, level, material, shoot};
use shade_core::effect::{Combine, Sun};
use shade_core::{AnySpatial, Sampling, Scene, Vector};

/// The origin of a white plate under a lamp straight above, a plate between them from `low` to
/// `high`.
fn under<V: Vector<T = f64>>(
    own: V::Law,
    law: &impl Sampling<V>,
    combine: Combine,
    low: [f64; 2],
    high: [f64; 2],
) -> Result<f64, String> {
    let s = 0.5f64.sqrt();
    let mut scene = Scene::<V>::new(camera(&[-0.1, 0.1, 0.0], &[s, -s, 0.0]));
    let white = material(&mut scene, diffuse(own, 1.0));
    let black = material(&mut scene, diffuse(own, 0.0));
    scene
        .plates
        .push(level(0.0, [-1.0; 2], [1.0; 2], white))
        .expect("room");
    scene
        .plates
        .push(level(0.8, low, high, black))
        .expect("room");
    scene
        .lamps
        .push(lamp(&[0.0, 2.0, 0.0], 0.6, 1.0))
        .expect("room");
    scene.combine = combine;
    let pixel = shoot(&scene, law, 1 << 15);
    // (R/d)² = 0.09 is the whole lamp.
    let share = pixel.mean()[0] / 0.09;
    agrees(&pixel, 0.09 * (share * 4.0).round() / 4.0).map(|()| (share * 4.0).round() / 4.0)
}

#[test]
fn umbra_half_and_quarter() {
    let shapes = [
        ([-0.9, -0.9], [0.9, 0.9], 0.0),
        ([0.0, -0.9], [0.9, 0.9], 0.5),
        ([0.0, 0.0], [0.9, 0.9], 0.75),
        ([0.5, -0.9], [0.9, 0.9], 1.0),
    ];
    for (low, high, lit) in shapes {
        for combine in [Combine::Balance, Combine::Light, Combine::Scatter] {
            assert_eq!(
                under::<[f64; 3]>(
                    AnySpatial::Lambert,
                    &AnySpatial::Lambert,
                    combine,
                    low,
                    high
                ),
                Ok(lit)
            );
        }
    }
    // Lamps sampled by the wrong measure: no multiple of a quarter.
    assert!(under::<Askew>(Plain, &Plain, Combine::Light, [0.5, -0.9], [0.9, 0.9]).is_err());
}

/// The penumbra in closed form: with a disc of angle α cut by a plane through the point that is
/// tilted by β, the foot (Nusselt) of what is seen is a part of the disc sin α bounded by half an
/// ellipse. Where the lamp is far and small, that is a straight cut of a disc at x = s sin α:
/// (arccos s − s √(1 − s²))/π is dark.
#[test]
fn penumbra_of_an_edge() {
    let seen = |edge: f64| {
        let s = 0.5f64.sqrt();
        let mut scene = Scene::<[f64; 3]>::new(camera(&[-0.1, 0.1, 0.0], &[s, -s, 0.0]));
        let white = material(&mut scene, diffuse(AnySpatial::Lambert, 1.0));
        scene
            .plates
            .push(level(0.0, [-1.0; 2], [1.0; 2], white))
            .expect("room");
        // Half-way to the lamp, where the lamp's radius is half as large.
        scene
            .plates
            .push(level(500.0, [edge, -9.0], [9.0, 9.0], white))
            .expect("room");
        scene
            .lamps
            .push(lamp(&[0.0, 1000.0, 0.0], 10.0, 1e4))
            .expect("room");
        shoot(&scene, &AnySpatial::Lambert, 1 << 16)
    };
    for s in [-0.8, -0.3, 0.0, 0.4, 0.9f64] {
        let dark = (s.acos() - s * (1.0 - s * s).sqrt()) / std::f64::consts::PI;
        assert_eq!(agrees(&seen(5.0 * s), 1.0 - dark), Ok(()), "{s}");
        assert!(agrees(&seen(5.0 * s), 1.0 - dark + 0.03).is_err());
    }
}

#[test]
fn the_sun_is_hard() {
    let seen = |low: f64, irradiance: f64| {
        let s = 0.5f64.sqrt();
        let mut scene = Scene::<[f64; 3]>::new(camera(&[-0.1, 0.1, 0.0], &[s, -s, 0.0]));
        let white = material(&mut scene, diffuse(AnySpatial::Lambert, 0.5));
        scene
            .plates
            .push(level(0.0, [-1.0; 2], [1.0; 2], white))
            .expect("room");
        scene
            .plates
            .push(level(1.0, [low, -1.0], [2.0, 1.0], white))
            .expect("room");
        scene.sun = Sun {
            towards: [0.6, 0.8, 0.0],
            irradiance: grey(irradiance),
        };
        shoot(&scene, &AnySpatial::Lambert, 2)
    };
    // The shadow's edge at height 1 is at x = ¾.
    assert_eq!(
        is_exactly(&seen(0.76, 2.0), 0.5 / std::f64::consts::PI * 2.0 * 0.8),
        Ok(())
    );
    assert_eq!(is_exactly(&seen(0.74, 2.0), 0.0), Ok(()));
    assert!(
        is_exactly(&seen(0.76, 2.0), 0.5 / std::f64::consts::PI * 2.0).is_err(),
        "no cosine"
    );
}
