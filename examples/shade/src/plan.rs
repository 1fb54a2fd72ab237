//! What a scene calls for, why, and what that costs.

use shade_core::{Cost, Counters, Effect, Effects, Sampling, Scene, Set, Vector, pixel};
use std::fmt::Write;

/// Why an effect is on, or why not.
fn why<V: Vector>(scene: &Scene<V>, effect: Effect, on: bool) -> String {
    let count = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
    let materials = |f: &dyn Fn(&shade_core::Material<V>) -> bool| {
        scene.materials.iter().filter(|m| f(m)).count()
    };
    let some = |c: &[V::T; 3]| c.iter().any(|&x| x.into() > 0.0);
    match (effect, on) {
        (Effect::Camera, _) if V::DIM == 2 => "a probe of the light at each pixel".to_owned(),
        (Effect::Camera, _) => "a ray through each pixel".to_owned(),
        (Effect::Filter, true) => format!("camera.filter = {}", scene.camera.filter.into()),
        (Effect::Filter, false) => "camera.filter is 0: the pixel's centre alone".to_owned(),
        (Effect::Lens, true) => format!("camera.lens.radius = {}", scene.camera.lens.into()),
        (Effect::Lens, false) => "no camera.lens: a pinhole".to_owned(),
        (Effect::Sky, true) => "the sky is not black".to_owned(),
        (Effect::Sky, false) => "the sky is black".to_owned(),
        (Effect::Emission, true) => {
            count(materials(&|m| some(&m.emission)), "material") + " with emission"
        }
        (Effect::Emission, false) => "no used material has emission".to_owned(),
        (Effect::Sun, true) => "a sun shines on something that scatters".to_owned(),
        (Effect::Sun, false) => "no sun, or nothing that scatters".to_owned(),
        (Effect::Lamp, true) => {
            format!("{} ({:?})", count(scene.lamps.len(), "lamp"), scene.combine)
        }
        (Effect::Lamp, false) => "no lamp".to_owned(),
        (Effect::Diffuse, true) => {
            count(materials(&|m| m.is_diffuse), "material") + " with a diffuse part"
        }
        (Effect::Gloss, true) => count(materials(&|m| m.share != 0), "material") + " with gloss",
        (Effect::Mix, true) => count(materials(&|m| m.is_mixed()), "material") + " with both",
        (Effect::Diffuse | Effect::Gloss | Effect::Mix, false) if scene.bounces == 0 => {
            "bounces = 0".to_owned()
        }
        (Effect::Diffuse | Effect::Gloss | Effect::Mix, false) => {
            "no used material asks for it".to_owned()
        }
        (Effect::Bounces, _) => format!("bounces = {}", scene.bounces),
        (Effect::Absorption, true) => "fog.absorption is not 0".to_owned(),
        (Effect::Scattering, true) => format!("fog.scattering = {}", scene.fog.scattering.into()),
        (Effect::Absorption | Effect::Scattering, false) => "no fog of that kind".to_owned(),
    }
}

/// How often an effect can be entered in one sample.
fn most<V: Vector>(scene: &Scene<V>, set: Set, effect: Effect) -> u32 {
    let scatters = [Effect::Diffuse, Effect::Gloss, Effect::Scattering];
    let limit = match u32::from(scene.bounces) {
        n if set.has(Effect::Bounces) => n,
        n if scatters.iter().any(|&e| set.has(e)) => n.min(1),
        _ => 0,
    };
    let probe = u32::from(V::DIM == 2);
    match effect {
        Effect::Camera | Effect::Filter | Effect::Lens | Effect::Sky => 1,
        Effect::Bounces => 0,
        Effect::Emission | Effect::Absorption => limit + 1,
        Effect::Sun => limit + probe,
        Effect::Lamp => (limit + probe) * scene.lamps.len() as u32,
        Effect::Diffuse | Effect::Gloss | Effect::Mix | Effect::Scattering => limit,
    }
}

/// The most that an effect can cost in one sample.
pub(crate) fn most_cost<V: Vector>(scene: &Scene<V>, set: Set, effect: Effect) -> Cost {
    let (once, n) = (effect.cost::<V>(), most(scene, set, effect));
    let lit = [Effect::Sky, Effect::Emission, Effect::Lamp];
    let last = u32::from(!lit.iter().any(|&e| set.has(e)));
    let reflects = matches!(effect, Effect::Diffuse | Effect::Gloss);
    // A last ray that could meet no light is not traced, nor its direction drawn.
    let n = if reflects { n.saturating_sub(last) } else { n };
    let mut cost = Cost {
        words: once.words * n,
        rays: once.rays * n,
    };
    if effect == Effect::Scattering {
        let directions = n.saturating_sub(last);
        cost.words += directions * Effect::Diffuse.cost::<V>().words.max(1);
        cost.rays += directions;
    }
    cost
}

/// Counts of a few samples, spread over the image.
pub(crate) fn counted<V: Vector, E: Effects, L: Sampling<V>>(
    scene: &Scene<V>,
    e: E,
    law: &L,
) -> (Counters, u32) {
    let (width, height) = (
        u32::from(scene.camera.width),
        u32::from(scene.camera.height),
    );
    let step = (width * height / 4096).max(1);
    let mut counters = Counters::default();
    let mut samples = 0;
    for i in (0..width * height).step_by(step as usize) {
        let at = ((i % width) as u16, (i / width) as u16);
        pixel(scene, e, law, at, 1, &mut counters);
        samples += 1;
    }
    (counters, samples)
}

/// The plan as it is printed.
pub(crate) fn describe<V: Vector, E: Effects, L: Sampling<V>>(
    scene: &Scene<V>,
    e: E,
    law: &L,
    needed: Set,
) -> String {
    let set = e.set();
    let (counters, samples) = counted(scene, e, law);
    let mean = |n: u64| n as f64 / f64::from(samples);
    let mut text = format!(
        "{:<28}{:<8}{:>15}{:>15}   {}\n",
        "effect", "", "rays a sample", "words a sample", "why"
    );
    for effect in Effect::ALL {
        let (on, i) = (set.has(effect), effect as usize);
        let state = match (on, needed.has(effect)) {
            (true, true) => "on",
            (true, false) => "forced",
            _ => "off",
        };
        let cost = most_cost(scene, set, effect);
        let both = |mean: f64, most: u32| {
            if on {
                format!("{mean:.2} (≤ {most})")
            } else {
                "–".to_owned()
            }
        };
        let rays = both(mean(counters.rays[i]), cost.rays);
        let words = both(mean(counters.words[i]), cost.words);
        let why = why(scene, effect, needed.has(effect));
        let _ = writeln!(
            text,
            "{:<28}{state:<8}{rays:>15}{words:>15}   {why}",
            effect.name()
        );
    }
    let total = |n: [u64; Effect::COUNT]| mean(n.iter().sum());
    let (rays, words) = (total(counters.rays), total(counters.words));
    let _ = writeln!(text, "{:<28}{:<8}{rays:>15.2}{words:>15.2}", "together", "");
    text
}
