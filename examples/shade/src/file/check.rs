//! What TOML's types do not say: sizes, ranges, and which keys belong to which world.

use super::ranges::{Checked, count, light, number, whole, wrong};
use super::raw::Raw;
use super::worlds::World;
use super::{BOUNCES, LARGEST, LEAST, SAMPLES, SIDE};
use toml::Spanned;

/// How many of each a scene may have: the capacities of `shade_core::Scene`.
const SPHERES: usize = 32;
const PLATES: usize = 16;
const LAMPS: usize = 4;
const MATERIALS: usize = 16;

/// What is wrong first, and where.
pub(super) fn check(raw: &Raw) -> Checked {
    let world = World { flat: raw.flatland };
    let image = &raw.image;
    whole("width", &image.width, 1..=SIDE)?;
    whole("height", &image.height, 1..=SIDE)?;
    whole("samples", &image.samples, 1..=SAMPLES)?;
    if let Some(seed) = &image.seed {
        whole("seed", seed, 0..=(1 << 24) - 1)?;
    }
    if let Some(exposure) = &image.exposure {
        number("exposure", exposure, LEAST..=LARGEST)?;
    }
    if let Some(bounces) = &raw.bounces {
        whole("bounces", bounces, 0..=BOUNCES)?;
    }
    match (&raw.law, &raw.exponent) {
        (Some(law), exponent) => world.law(law, exponent.as_ref())?,
        (None, Some(k)) => {
            return Err(wrong(
                k,
                "an exponent without a law; expected `law = \"cos_power\"`",
            ));
        }
        (None, None) => {}
    }
    world.camera(&raw.camera)?;
    if let Some(at) = &raw.sky {
        let sky = at.get_ref();
        match (&sky.constant, &sky.nadir, &sky.zenith) {
            (Some(constant), None, None) => light("sky.constant", constant)?,
            (None, Some(nadir), Some(zenith)) => {
                light("sky.nadir", nadir)?;
                light("sky.zenith", zenith)?;
            }
            _ => {
                return Err(wrong(
                    at,
                    "sky; expected either `constant` or both `nadir` and `zenith`",
                ));
            }
        }
    }
    if let Some(sun) = &raw.sun {
        world.direction("sun.towards", &sun.towards)?;
        light("sun.irradiance", &sun.irradiance)?;
    }
    if let Some(fog) = &raw.fog {
        world.vector("fog.centre", &fog.centre)?;
        number("fog.radius", &fog.radius, LEAST..=LARGEST)?;
        if let Some(absorption) = &fog.absorption {
            light("fog.absorption", absorption)?;
        }
        if let Some(scattering) = &fog.scattering {
            number("fog.scattering", scattering, 0.0..=LARGEST)?;
        }
    }
    if let Some((name, _)) = raw.material.iter().nth(MATERIALS) {
        return Err(wrong(
            name,
            format!(
                "{} materials; expected at most {MATERIALS}",
                raw.material.len()
            ),
        ));
    }
    for material in raw.material.values() {
        world.material(material)?;
    }
    count("lamp", &raw.lamp, LAMPS)?;
    for lamp in raw.lamp.iter().map(Spanned::get_ref) {
        world.vector("lamp.centre", &lamp.centre)?;
        number("lamp.radius", &lamp.radius, LEAST..=LARGEST)?;
        light("lamp.radiance", &lamp.radiance)?;
    }
    count("sphere", &raw.sphere, SPHERES)?;
    for sphere in raw.sphere.iter().map(Spanned::get_ref) {
        world.vector("sphere.centre", &sphere.centre)?;
        number("sphere.radius", &sphere.radius, LEAST..=LARGEST)?;
        named(raw, &sphere.material)?;
    }
    count("plate", &raw.plate, PLATES)?;
    for plate in &raw.plate {
        world.plate(plate)?;
        named(raw, &plate.get_ref().material)?;
    }
    Ok(())
}

fn named(raw: &Raw, name: &Spanned<String>) -> Checked {
    let mut names = raw.material.keys().map(|k| k.get_ref().as_str());
    if names.any(|n| n == name.get_ref()) {
        return Ok(());
    }
    let all: Vec<&str> = raw.material.keys().map(|k| k.get_ref().as_str()).collect();
    let known = if all.is_empty() {
        "a table [material.NAME] for it".to_owned()
    } else {
        format!("one of {}", all.join(", "))
    };
    Err(wrong(
        name,
        format!("no material {:?}; expected {known}", name.get_ref()),
    ))
}
