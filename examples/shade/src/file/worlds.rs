//! What differs between space and flatland, and what is checked of one table.

use super::ranges::{Checked, components, light, number, share, wrong};
use super::raw::{Camera, Gloss, Material, Plate, Value, Values};
use super::{LARGEST, LEAST};
use shade_core::LawName;
use toml::Spanned;

/// Space or flatland: what their keys have to be.
pub(super) struct World {
    pub(super) flat: bool,
}

impl World {
    pub(super) fn vector(&self, key: &str, x: &Values) -> Checked {
        let (n, what) = if self.flat {
            (2, "x, y: a scene in flatland")
        } else {
            (3, "x, y, z: a scene in space")
        };
        components(key, x, n, -LARGEST..=LARGEST, what)
    }

    pub(super) fn direction(&self, key: &str, x: &Values) -> Checked {
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

    pub(super) fn law(&self, law: &Spanned<LawName>, exponent: Option<&Value>) -> Checked {
        if LawName::PLANAR.contains(law.get_ref()) != self.flat {
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

    pub(super) fn camera(&self, at: &Spanned<Camera>) -> Checked {
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

    pub(super) fn gloss(&self, gloss: &Gloss) -> Checked {
        share("gloss.reflectance", &gloss.reflectance)?;
        self.law(&gloss.law, gloss.exponent.as_ref())
    }

    pub(super) fn material(&self, at: &Spanned<Material>) -> Checked {
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

    pub(super) fn plate(&self, at: &Spanned<Plate>) -> Checked {
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
