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

<<<<<<< HEAD
fn wrong<T>(at: &Spanned<T>, what: impl Into<String>) -> Wrong {
    (at.span(), what.into())
}

fn number(key: &str, x: &Value, range: RangeInclusive<f64>) -> Checked {
    if range.contains(x.get_ref()) {
        return Ok(());
    }
    let (low, high) = (range.start(), range.end());
    let what = format!("{key} is {}; expected {low} to {high}", x.get_ref());
    Err(wrong(x, what))
}

fn whole(key: &str, x: &Spanned<i64>, range: RangeInclusive<i64>) -> Checked {
    if range.contains(x.get_ref()) {
        return Ok(());
    }
    let (low, high) = (range.start(), range.end());
    let what = format!(
        "{key} is {}; expected a whole number from {low} to {high}",
        x.get_ref()
    );
    Err(wrong(x, what))
}

fn components(key: &str, x: &Values, n: usize, range: RangeInclusive<f64>, what: &str) -> Checked {
    if x.get_ref().len() != n {
        let have = x.get_ref().len();
        return Err(wrong(
            x,
            format!("{key} has {have} numbers; expected {n} ({what})"),
        ));
    }
    match x.get_ref().iter().find(|&&c| !range.contains(&c)) {
        None => Ok(()),
        Some(c) => {
            let (low, high) = (range.start(), range.end());
            Err(wrong(
                x,
                format!("{key} holds {c}; expected {low} to {high}"),
            ))
        }
    }
}

fn light(key: &str, x: &Values) -> Checked {
    components(key, x, 3, 0.0..=LARGEST, "red, green, blue")
}

fn share(key: &str, x: &Values) -> Checked {
    components(key, x, 3, 0.0..=1.0, "red, green, blue")
}

fn count<T>(key: &str, list: &[Spanned<T>], most: usize) -> Checked {
    match list.get(most) {
        Some(one) => Err(wrong(
            one,
            format!("{} of [[{key}]]; expected at most {most}", list.len()),
        )),
        None => Ok(()),
    }
}

struct World {
    flat: bool,
}

impl World {
    fn vector(&self, key: &str, x: &Values) -> Checked {
        let (n, what) = if self.flat {
            (2, "x, y: a scene in flatland")
        } else {
            (3, "x, y, z: a scene in space")
        };
        components(key, x, n, -LARGEST..=LARGEST, what)
    }

    fn direction(&self, key: &str, x: &Values) -> Checked {
        self.vector(key, x)?;
        let length = x.get_ref().iter().map(|c| c * c).sum::<f64>().sqrt();
        if length < LEAST {
            return Err(wrong(
                x,
                format!("{key} has length {length}; expected at least {LEAST}"),
            ));
        }
        Ok(())
    }

    fn law(&self, law: &Spanned<LawName>, exponent: Option<&Value>) -> Checked {
        if law.get_ref().is_flat() != self.flat {
            let what = if self.flat {
                "a law of space in flatland; expected circle_arc, circle_shell or disk"
            } else {
                "a law of flatland in space; expected lambert, sphere_shell, ball or cos_power"
            };
            return Err(wrong(law, what));
        }
        match (*law.get_ref() == LawName::CosPower, exponent) {
            (true, Some(k)) => number("exponent", k, 0.0..=LARGEST),
            (true, None) => Err(wrong(
                law,
                "cos_power without a key `exponent`; expected its k",
            )),
            (false, Some(k)) => Err(wrong(
                k,
                "an exponent; expected none, as the law is not cos_power",
            )),
            (false, None) => Ok(()),
        }
    }

    fn camera(&self, at: &Spanned<Camera>) -> Checked {
        let c = at.get_ref();
        if let Some(filter) = &c.filter {
            number("filter", filter, 0.0..=16.0)?;
        }
        if self.flat {
            let (Some(centre), Some(height)) = (&c.centre, &c.height) else {
                return Err(wrong(
                    at,
                    "camera of a scene in flatland; expected `centre` and `height`",
                ));
            };
            if c.eye.is_some() || c.look_at.is_some() || c.fov.is_some() || c.lens.is_some() {
                return Err(wrong(
                    at,
                    "camera of a scene in flatland with `eye`, `look_at`, `fov` or `lens`; expected `centre` and `height` alone",
                ));
            }
            self.vector("centre", centre)?;
            return number("height", height, LEAST..=LARGEST);
        }
        let (Some(eye), Some(look_at), Some(fov)) = (&c.eye, &c.look_at, &c.fov) else {
            return Err(wrong(
                at,
                "camera of a scene in space; expected `eye`, `look_at` and `fov`",
            ));
        };
        if c.centre.is_some() || c.height.is_some() {
            return Err(wrong(
                at,
                "camera of a scene in space with `centre` or `height`; expected `eye`, `look_at` and `fov`",
            ));
        }
        self.vector("eye", eye)?;
        self.vector("look_at", look_at)?;
        number("fov", fov, 0.1..=170.0)?;
        let apart = eye
            .get_ref()
            .iter()
            .zip(look_at.get_ref())
            .map(|(a, b)| (a - b).abs());
        if apart.fold(0.0, f64::max) < LEAST {
            return Err(wrong(
                look_at,
                "look_at is where the eye is; expected another point",
            ));
        }
        let Some(lens) = &c.lens else { return Ok(()) };
        number("lens.radius", &lens.get_ref().radius, 0.0..=LARGEST)?;
        number("lens.focus", &lens.get_ref().focus, LEAST..=LARGEST)
    }

    fn gloss(&self, gloss: &Gloss) -> Checked {
        share("gloss.reflectance", &gloss.reflectance)?;
        self.law(&gloss.law, gloss.exponent.as_ref())
    }

    fn material(&self, at: &Spanned<Material>) -> Checked {
        let m = at.get_ref();
        let mut sum = [0.0; 3];
        let mut add = |x: &Values| sum.iter_mut().zip(x.get_ref()).for_each(|(a, b)| *a += b);
        if let Some(diffuse) = &m.diffuse {
            share("diffuse", diffuse)?;
            add(diffuse);
        }
        if let Some(gloss) = &m.gloss {
            self.gloss(gloss.get_ref())?;
            add(&gloss.get_ref().reflectance);
        }
        if let Some(emission) = &m.emission {
            light("emission", emission)?;
        }
        match sum.iter().find(|&&s| s > 1.0 + 1e-9) {
            Some(s) => Err(wrong(
                at,
                format!("diffuse + gloss.reflectance is {s}; expected at most 1"),
            )),
            None => Ok(()),
        }
    }

    fn plate(&self, at: &Spanned<Plate>) -> Checked {
        let p = at.get_ref();
        self.vector("plate.centre", &p.centre)?;
        let sides = p.sides.get_ref();
        let want = if self.flat { 1 } else { 2 };
        if sides.len() != want {
            return Err(wrong(
                &p.sides,
                format!("{} sides; expected {want}", sides.len()),
            ));
        }
        for side in sides {
            self.direction("a side", side)?;
        }
        if let [a, b] = &sides[..] {
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let (a, b) = (a.get_ref(), b.get_ref());
            let cos = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
            if cos.abs() > 1e-6 {
                return Err(wrong(
                    &p.sides,
                    format!("sides at an angle of cosine {cos}; expected a right angle"),
                ));
            }
        }
        Ok(())
    }
}

=======
>>>>>>> h-shade
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
