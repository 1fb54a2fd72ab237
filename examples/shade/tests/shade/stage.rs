//! Scenes of one pixel, and what a check says of its estimate.

use shade_core::effect::Lamp;
use shade_core::{
    AnySpatial, Asked, Camera, Material, Number, Pixel, Plate, Sampling, Scene, Sphere, Vector,
    pixel,
};

/// Standard errors that an estimate may be off; the seeds are fixed.
const SIGMAS: f64 = 5.0;

pub(crate) fn v<V: Vector>(x: &[f64]) -> V {
    V::from_fn(|i| V::T::from_f64(x[i]))
}

pub(crate) fn grey<T: Number>(x: f64) -> [T; 3] {
    [T::from_f64(x); 3]
}

/// A pixel that looks from `eye` along the unit vector `forward`; in flatland a probe at `eye`.
pub(crate) fn camera<V: Vector>(eye: &[f64], forward: &[f64]) -> Camera<V> {
    let one = V::T::from_f64(1.0);
    let none = V::T::from_f64(0.0);
    Camera {
        eye: v(eye),
        // The single pixel's middle is the image's: its axes do not matter.
        right: v(&[1.0, 0.0, 0.0]),
        up: v(&[0.0, 1.0, 0.0]),
        forward: v(forward),
        step: one,
        width: 1,
        height: 1,
        filter: none,
        lens: none,
        focus: one,
    }
}

pub(crate) fn diffuse<V: Vector>(law: V::Law, albedo: f64) -> Material<V> {
    Material::new(grey(albedo), grey(0.0), law, grey(0.0))
}

/// k of a law cosᵏθ, from its mean cosine (k + 1)/(k + 2).
pub(crate) fn exponent(law: &AnySpatial<f64>) -> f64 {
    let mean = law.mean_cos();
    ((2.0 * mean - 1.0) / (1.0 - mean) * 1e6).round() / 1e6
}

/// Adds a material and returns its index.
pub(crate) fn material<V: Vector>(scene: &mut Scene<V>, material: Material<V>) -> u8 {
    scene.materials.push(material).expect("room");
    scene.materials.len() as u8 - 1
}

pub(crate) fn sphere<V: Vector>(centre: &[f64], radius: f64, material: u8) -> Sphere<V> {
    Sphere {
        centre: v(centre),
        radius: V::T::from_f64(radius),
        material,
    }
}

/// A plate across the y axis from `low` to `high` in x (and z), at height y.
pub(crate) fn level<V: Vector>(y: f64, low: [f64; 2], high: [f64; 2], material: u8) -> Plate<V> {
    let middle = |i: usize| (low[i] + high[i]) / 2.0;
    Plate {
        centre: v(&[middle(0), y, middle(1)]),
        normal: v(&[0.0, 1.0, 0.0]),
        axes: [v(&[1.0, 0.0, 0.0]), v(&[0.0, 0.0, 1.0])],
        half: [0, 1].map(|i| V::T::from_f64((high[i] - low[i]) / 2.0)),
        material,
    }
}

pub(crate) fn lamp<V: Vector>(centre: &[f64], radius: f64, radiance: f64) -> Lamp<V> {
    Lamp {
        shape: sphere(centre, radius, 0),
        radiance: grey(radiance),
    }
}

/// The scene's only pixel, with the effects that it calls for.
pub(crate) fn shoot<V: Vector, L: Sampling<V>>(
    scene: &Scene<V>,
    law: &L,
    samples: u32,
) -> Pixel<V::T> {
    pixel(
        scene,
        Asked(scene.called_for()),
        law,
        (0, 0),
        samples,
        &mut (),
    )
}

/// Whether the estimate is `want`, within its own standard error and the rounding of the type.
pub(crate) fn agrees<T: Number>(pixel: &Pixel<T>, want: f64) -> Result<(), String> {
    let error = (pixel.variance()[0] / f64::from(pixel.count)).sqrt();
    let have = pixel.mean()[0];
    let slack = SIGMAS * error + 2e-6 * want.abs();
    if (have - want).abs() <= slack {
        Ok(())
    } else {
        Err(format!("{have} ± {error}; expected {want}"))
    }
}

/// Whether the estimate is `want` to a part in `10⁶` without noise.
pub(crate) fn is_exactly<T: Number>(pixel: &Pixel<T>, want: f64) -> Result<(), String> {
    if pixel.variance()[0] > 1e-12 {
        return Err(format!("variance {}; expected none", pixel.variance()[0]));
    }
    agrees(pixel, want)
}
