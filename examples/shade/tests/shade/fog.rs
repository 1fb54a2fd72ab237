//! Fog by Beer and Lambert.

use crate::stage::{agrees, camera, diffuse, grey, is_exactly, level, material, shoot, sphere};
use shade_core::effect::{Sky, Sun};
use shade_core::{AnyPlanar, AnySpatial, Material, Number, Pixel, Scene, Vector};

/// A shining plate of radiance 2 seen down through a ball of fog of radius 1.5, aside of its centre
/// by 0.9: a chord of 2.4.
fn behind_fog<T: Number>(absorption: f64, scattering: f64, bounces: u16) -> Pixel<T> {
    let mut scene = Scene::<[T; 3]>::new(camera(&[0.9, 5.0, 0.0], &[0.0, -1.0, 0.0]));
    let shining = Material::new(grey(0.0), grey(0.0), AnySpatial::Lambert, grey(2.0));
    let shining = material(&mut scene, shining);
    // A plate so small that nothing scattered in the fog finds it.
    scene
        .plates
        .push(level(-2.0, [0.899, -1e-3], [0.901, 1e-3], shining))
        .expect("room");
    scene.fog.region = sphere(&[0.0, 0.0, 0.0], 1.5, 0);
    scene.fog.absorption = grey(absorption);
    scene.fog.scattering = T::from_f64(scattering);
    scene.bounces = bounces;
    shoot(&scene, &AnySpatial::Lambert, 1 << 14)
}

const CHORD: f64 = 2.4;

#[test]
fn absorption_is_exact() {
    let want = |sigma: f64| 2.0 * (-sigma * CHORD).exp();
    assert_eq!(
        is_exactly(&behind_fog::<f64>(0.3, 0.0, 1), want(0.3)),
        Ok(())
    );
    assert_eq!(
        is_exactly(&behind_fog::<f32>(0.3, 0.0, 1), want(0.3)),
        Ok(())
    );
    // Without a bounce to follow, scattering is known as well.
    assert_eq!(
        is_exactly(&behind_fog::<f64>(0.3, 0.4, 0), want(0.7)),
        Ok(())
    );
    assert!(
        is_exactly(&behind_fog::<f64>(0.6, 0.0, 1), want(0.3)).is_err(),
        "doubled"
    );
    assert!(
        is_exactly(&behind_fog::<f64>(0.0, 0.3, 1), want(0.3)).is_err(),
        "as scattering"
    );
}

#[test]
fn what_is_not_scattered() {
    let want = |sigma: f64| 2.0 * (-sigma * CHORD).exp();
    assert_eq!(agrees(&behind_fog::<f64>(0.0, 0.5, 1), want(0.5)), Ok(()));
    assert_eq!(agrees(&behind_fog::<f32>(0.2, 0.5, 3), want(0.7)), Ok(()));
    assert!(
        agrees(&behind_fog::<f64>(0.0, 1.0, 1), want(0.5)).is_err(),
        "doubled"
    );
}

/// The sun from above on a plate in a ball of fog of radius R around it: the light and its
/// reflection go R each, and at most one scattering is followed.
#[test]
fn sun_through_fog() {
    let seen = |factor: f64| {
        let mut scene = Scene::<[f64; 3]>::new(camera(&[0.0, 5.0, 0.0], &[0.0, -1.0, 0.0]));
        let white = material(&mut scene, diffuse(AnySpatial::Lambert, 0.5));
        scene
            .plates
            .push(level(0.0, [-9.0; 2], [9.0; 2], white))
            .expect("room");
        scene.sun = Sun {
            towards: [0.0, 1.0, 0.0],
            irradiance: grey(3.0),
        };
        scene.fog.region = sphere(&[0.0; 3], 2.0, 0);
        scene.fog.absorption = grey(0.25 * factor);
        shoot(&scene, &AnySpatial::Lambert, 4)
    };
    let want = 0.5 * 3.0 / std::f64::consts::PI * (-0.25f64 * 4.0).exp();
    assert_eq!(is_exactly(&seen(1.0), want), Ok(()));
    assert!(is_exactly(&seen(2.0), want).is_err());
}

/// One scattering of the sun's light along the view through a thin ball of fog, in closed form
/// where view and sun are the same axis: ∫ σ e^(−σ(t + t)) E/4π dt = E (1 − e^(−2σl))/8π, l the
/// chord.
#[test]
fn single_scattering_of_the_sun() {
    let seen = |sigma: f64| {
        let mut scene = Scene::<[f64; 3]>::new(camera(&[0.0, 5.0, 0.0], &[0.0, -1.0, 0.0]));
        scene.sun = Sun {
            towards: [0.0, 1.0, 0.0],
            irradiance: grey(3.0),
        };
        scene.fog.region = sphere(&[0.0; 3], 1.0, 0);
        scene.fog.scattering = sigma;
        shoot(&scene, &AnySpatial::Lambert, 1 << 15)
    };
    let want = |sigma: f64| 3.0 * (1.0 - (-4.0 * sigma).exp()) / (8.0 * std::f64::consts::PI);
    assert_eq!(agrees(&seen(0.4), want(0.4)), Ok(()));
    assert!(agrees(&seen(0.8), want(0.4)).is_err());
}

/// Fog that only scatters, under a sky of 1: a path that is followed to its end brings 1 home.
#[test]
fn fog_in_the_furnace() {
    fn check<V: Vector>(law: impl shade_core::Sampling<V>) {
        let mut scene = Scene::<V>::new(camera(&[0.0, 0.0, 0.2], &[0.0, 1.0, 0.0]));
        scene.sky = Sky {
            nadir: grey(1.0),
            zenith: grey(1.0),
        };
        scene.fog.region = sphere(&[0.0; 3], 1.0, 0);
        scene.fog.scattering = V::T::from_f64(0.7);
        scene.bounces = 64;
        assert_eq!(is_exactly(&shoot(&scene, &law, 1 << 10), 1.0), Ok(()));
        // Fewer bounces lose what is scattered more often: never more than 1.
        scene.bounces = 2;
        let less = shoot(&scene, &law, 1 << 10).mean()[0];
        assert!(less < 1.0 && less > 0.5);
    }
    check::<[f64; 3]>(AnySpatial::Lambert);
    check::<[f64; 2]>(AnyPlanar::CircleShell);
}
