//! From a checked file to the core's scene, in any number type.

use super::raw::{CombineName, Raw, Value, Values};
use shade_core::effect::{Combine, Fog, Lamp, Sky, Sun};
use shade_core::{
    AnyPlanar, AnySpatial, Camera, LawName, Material, Number, Plate, Rgb, Scene, Sphere, Vector,
};
use toml::Spanned;

/// What differs between the worlds as files see them.
pub trait World: Vector {
    /// The law of that name; `None` in the other world.
    fn law(name: LawName, exponent: f64) -> Option<Self::Law>;
    /// A diffuse surface's own.
    fn diffuse_law() -> Self::Law;
}

impl<T: Number> World for [T; 3] {
    fn law(name: LawName, exponent: f64) -> Option<AnySpatial<T>> {
        AnySpatial::named(name, T::from_f64(exponent))
    }
    fn diffuse_law() -> AnySpatial<T> {
        AnySpatial::Lambert
    }
}

impl<T: Number> World for [T; 2] {
    fn law(name: LawName, _: f64) -> Option<AnyPlanar> {
        AnyPlanar::named(name)
    }
    fn diffuse_law() -> AnyPlanar {
        AnyPlanar::CircleShell
    }
}

fn vector<V: Vector>(x: &[f64]) -> V {
    V::from_fn(|i| V::T::from_f64(x[i]))
}

fn rgb<T: Number>(x: &Values) -> Rgb<T> {
    core::array::from_fn(|i| T::from_f64(x.get_ref()[i]))
}

fn or_black<T: Number>(x: Option<&Values>) -> Rgb<T> {
    x.map_or([T::ZERO; 3], rgb)
}

fn number<T: Number>(x: &Value) -> T {
    T::from_f64(*x.get_ref())
}

fn scaled(a: &[f64], k: f64) -> Vec<f64> {
    a.iter().map(|x| x * k).collect()
}

/// a/|a| in `f64`, rounded once for each number type, and |a|.
fn unit(a: &[f64]) -> (Vec<f64>, f64) {
    let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
    (scaled(a, 1.0 / length), length)
}

fn cross(a: &[f64], b: &[f64]) -> [f64; 3] {
    core::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

fn camera<V: Vector>(raw: &Raw) -> Camera<V> {
    let c = raw.camera.get_ref();
    let (width, height) = (*raw.image.width.get_ref(), *raw.image.height.get_ref());
    let get = |x: &Option<Values>| x.as_ref().map_or(vec![0.0; 3], |x| x.get_ref().clone());
    let (eye, forward, right, up, step);
    if raw.flatland {
        eye = get(&c.centre);
        (forward, right, up) = (vec![0.0; 2], vec![1.0, 0.0], vec![0.0, 1.0]);
        step = c.height.as_ref().map_or(1.0, |h| *h.get_ref());
    } else {
        eye = get(&c.eye);
        let to: Vec<f64> = get(&c.look_at)
            .iter()
            .zip(&eye)
            .map(|(a, b)| a - b)
            .collect();
        forward = unit(&to).0;
        // Looking straight up or down, the image's top is −z.
        let vertical = forward[1].abs() > 1.0 - 1e-9;
        let above = if vertical {
            [0.0, 0.0, -1.0]
        } else {
            [0.0, 1.0, 0.0]
        };
        right = unit(&cross(&forward, &above)).0;
        up = cross(&right, &forward).to_vec();
        let half = c.fov.as_ref().map_or(45.0, |f| *f.get_ref()).to_radians() / 2.0;
        // Not std's tangent, whose last bits differ between systems.
        step = 2.0 * libm::tan(half);
    }
    let lens = c.lens.as_ref().map(Spanned::get_ref);
    Camera {
        eye: vector(&eye),
        right: vector(&right),
        up: vector(&up),
        forward: vector(&forward),
        step: V::T::from_f64(step / height as f64),
        width: width as u16,
        height: height as u16,
        filter: V::T::from_f64(c.filter.as_ref().map_or(0.0, |f| *f.get_ref())),
        lens: V::T::from_f64(lens.map_or(0.0, |l| *l.radius.get_ref())),
        focus: V::T::from_f64(lens.map_or(1.0, |l| *l.focus.get_ref())),
    }
}

fn plate<V: Vector>(centre: &Values, sides: &[Values], material: u8) -> Plate<V> {
    let (first, length) = unit(sides[0].get_ref());
    let (second, other, normal) = match sides.get(1) {
        None => (vec![0.0; 2], 0.0, vec![-first[1], first[0]]),
        Some(side) => {
            let (second, other) = unit(side.get_ref());
            let normal = unit(&cross(&second, &first)).0;
            (second, other, normal)
        }
    };
    Plate {
        centre: vector(centre.get_ref()),
        normal: vector(&normal),
        axes: [vector(&first), vector(&second)],
        half: [length, other].map(|l| V::T::from_f64(l / 2.0)),
        material,
    }
}

/// The scene of a checked file, and the law of its diffuse directions (`law` before the file's
/// own). `None` if that law is of the other world.
pub fn scene<V: World>(raw: &Raw, law: Option<LawName>) -> Option<(Scene<V>, V::Law)> {
    let exponent = |k: &Option<Value>| k.as_ref().map_or(1.0, |k| *k.get_ref());
    let named = law.or(raw.law.as_ref().map(|l| *l.get_ref()));
    let law = match named {
        Some(name) => V::law(name, exponent(&raw.exponent))?,
        None => V::diffuse_law(),
    };
    let mut scene = Scene::new(camera(raw));
    scene.bounces = raw.bounces.as_ref().map_or(1, |b| *b.get_ref() as u16);
    scene.seed = raw.image.seed.as_ref().map_or(0, |s| *s.get_ref() as u32);
    scene.combine = match raw.combine {
        CombineName::Balance => Combine::Balance,
        CombineName::Power => Combine::Power,
        CombineName::Light => Combine::Light,
        CombineName::Scatter => Combine::Scatter,
    };
    if let Some(sky) = raw.sky.as_ref().map(Spanned::get_ref) {
        let both = sky.constant.as_ref();
        scene.sky = Sky {
            nadir: or_black(both.or(sky.nadir.as_ref())),
            zenith: or_black(both.or(sky.zenith.as_ref())),
        };
    }
    if let Some(sun) = &raw.sun {
        scene.sun = Sun {
            towards: vector(&unit(sun.towards.get_ref()).0),
            irradiance: rgb(&sun.irradiance),
        };
    }
    let sphere = |centre: &Values, radius: &Value, material| Sphere {
        centre: vector(centre.get_ref()),
        radius: number(radius),
        material,
    };
    if let Some(fog) = &raw.fog {
        scene.fog = Fog {
            region: sphere(&fog.centre, &fog.radius, 0),
            absorption: or_black(fog.absorption.as_ref()),
            scattering: fog.scattering.as_ref().map_or(V::T::from_f64(0.0), number),
        };
    }
    for m in raw.material.values().map(Spanned::get_ref) {
        let gloss = m.gloss.as_ref().map(Spanned::get_ref);
        let lobe = match gloss {
            Some(g) => V::law(*g.law.get_ref(), exponent(&g.exponent))?,
            None => V::diffuse_law(),
        };
        let material = Material::new(
            or_black(m.diffuse.as_ref()),
            or_black(gloss.map(|g| &g.reflectance)),
            lobe,
            or_black(m.emission.as_ref()),
        );
        scene.materials.push(material).ok()?;
    }
    let index = |name: &Spanned<String>| {
        let mut names = raw.material.keys();
        names
            .position(|n| n.get_ref() == name.get_ref())
            .map(|i| i as u8)
    };
    for s in raw.sphere.iter().map(Spanned::get_ref) {
        let sphere = sphere(&s.centre, &s.radius, index(&s.material)?);
        scene.spheres.push(sphere).ok()?;
    }
    for p in raw.plate.iter().map(Spanned::get_ref) {
        let plate = plate(&p.centre, p.sides.get_ref(), index(&p.material)?);
        scene.plates.push(plate).ok()?;
    }
    for l in raw.lamp.iter().map(Spanned::get_ref) {
        let shape = sphere(&l.centre, &l.radius, 0);
        let radiance = rgb(&l.radiance);
        scene.lamps.push(Lamp { shape, radiance }).ok()?;
    }
    Some((scene, law))
}
