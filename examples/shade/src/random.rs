//! Random scenes for tests and fuzzing, whose numbers are those that go wrong: touching, nested,
//! far off, tiny and huge.

use crate::file::World;
use shade_core::effect::{Combine, Fog, Lamp, Sky, Sun};
use shade_core::{
    Asked, Camera, LawName, Material, Number, Plate, Rgb, Scene, Sphere, Vector, pixel,
};

/// Makes choices: a number below that which it is given.
pub trait Choose {
    /// One.
    fn below(&mut self, n: usize) -> usize;

    /// One of a list.
    fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }
    /// A length above 0.
    fn length(&mut self) -> f64 {
        let plain = 0.25 + self.below(64) as f64 / 16.0;
        self.of(&[plain, plain, 1.0, 1.0, 0.5, 2.0, 1e-6, 1e-3, 10.0, 3e3, 1e6])
    }
    /// Of −1, 0, 1, and any length, mostly small.
    fn coordinate(&mut self) -> f64 {
        let size = self.length();
        let sign = self.of(&[0.0, 0.0, 1.0, -1.0]);
        let most = self.of(&[1.0, 4.0, 4.0, 4.0, 1e6]);
        sign * size.min(most)
    }
    /// Red, green and blue.
    fn light(&mut self) -> [f64; 3] {
        let size = self.of(&[0.0, 1.0, 1.0, 0.7, 1e-6, 1e6]);
        [size, size * 0.5, size * self.of(&[0.0, 1.0])]
    }
}

type Point = [f64; 3];

fn v<V: Vector>(x: Point) -> V {
    V::from_fn(|i| V::T::from_f64(x[i]))
}

fn rgb<T: Number>(x: [f64; 3]) -> Rgb<T> {
    x.map(T::from_f64)
}

/// Three unit vectors at right angles, in flatland the first two in its plane.
fn axes(choose: &mut impl Choose, flat: bool) -> [Point; 3] {
    let angles = [0.0, 0.0, 0.0, 1.0, 0.3, 1e-7, std::f64::consts::FRAC_PI_2];
    let (s, c) = choose.of(&angles).sin_cos();
    let (t, d) = if flat { 0.0 } else { choose.of(&angles) }.sin_cos();
    let axes = [[c, s, 0.0], [-s * d, c * d, t], [s * t, -c * t, d]];
    let turn = if flat {
        choose.of(&[[0, 1, 2], [1, 0, 2]])
    } else {
        choose.of(&[[0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]])
    };
    turn.map(|i| axes[i])
}

/// The round shapes so far, for others to touch.
type Round = (Point, f64);

fn point(choose: &mut impl Choose, known: &[Round]) -> Point {
    let mut p = [(); 3].map(|()| choose.coordinate());
    if !known.is_empty() && choose.below(2) == 0 {
        // At, on or in another.
        let (centre, radius) = choose.of(known);
        p = centre;
        p[choose.below(2)] += radius * choose.of(&[0.0, 1.0, -1.0, 0.5, 2.0]);
    }
    p.map(|x| x.clamp(-1e6, 1e6))
}

fn round<V: Vector>(choose: &mut impl Choose, known: &mut Vec<Round>, material: u8) -> Sphere<V> {
    let (centre, radius) = (point(choose, known), choose.length());
    known.push((centre, radius));
    Sphere {
        centre: v(centre),
        radius: V::T::from_f64(radius),
        material,
    }
}

fn law<V: World>(choose: &mut impl Choose) -> V::Law {
    let name = if V::DIM == 2 {
        choose.of(&LawName::PLANAR)
    } else {
        choose.of(&LawName::SPATIAL)
    };
    let exponent = choose.of(&[0.0, 1e-6, 0.5, 1.0, 20.0, 1e6]);
    V::law(name, exponent).expect("a law of this world")
}

fn camera<V: Vector>(choose: &mut impl Choose, known: &[Round]) -> Camera<V> {
    let [right, up, forward] = axes(choose, V::DIM == 2);
    Camera {
        eye: v(point(choose, known)),
        right: v(right),
        up: v(up),
        forward: v(forward),
        step: V::T::from_f64(choose.length()),
        width: 3,
        height: 3,
        filter: V::T::from_f64(choose.of(&[0.0, 1.0, 16.0])),
        lens: V::T::from_f64(choose.of(&[0.0, 0.0, 0.1, 1e6])),
        focus: V::T::from_f64(choose.length()),
    }
}

/// A scene that a file could hold, and the law of its diffuse directions.
pub fn scene<V: World>(choose: &mut impl Choose) -> (Scene<V>, V::Law) {
    let mut known = Vec::new();
    let mut scene = Scene::new(camera(choose, &known));
    for _ in 0..3 {
        let d = choose.of(&[0.0, 0.5, 1.0, 1e-6]);
        let g = choose.of(&[0.0, 0.5, 1.0, 1e-6]) * (1.0 - d);
        let emission = if choose.below(3) == 0 {
            choose.light()
        } else {
            [0.0; 3]
        };
        let material = Material::new(rgb([d; 3]), rgb([g; 3]), law::<V>(choose), rgb(emission));
        let _ = scene.materials.push(material);
    }
    for _ in 0..choose.below(4) {
        let material = choose.below(3) as u8;
        let _ = scene.spheres.push(round(choose, &mut known, material));
    }
    for _ in 0..choose.below(3) {
        let radiance = rgb(choose.light());
        let shape = round(choose, &mut known, 0);
        let _ = scene.lamps.push(Lamp { shape, radiance });
    }
    for _ in 0..choose.below(4) {
        let [a, b, normal] = axes(choose, V::DIM == 2);
        let (b, normal) = if V::DIM == 2 {
            ([0.0; 3], b)
        } else {
            (b, normal)
        };
        let other = if V::DIM == 2 { 0.0 } else { choose.length() };
        let _ = scene.plates.push(Plate {
            centre: v(point(choose, &known)),
            normal: v(normal),
            axes: [v(a), v(b)],
            half: [choose.length(), other].map(|l| V::T::from_f64(l / 2.0)),
            material: choose.below(3) as u8,
        });
    }
    scene.camera = camera(choose, &known);
    scene.sky = Sky {
        nadir: rgb(choose.light()),
        zenith: rgb(choose.light()),
    };
    scene.sun = Sun {
        towards: v(axes(choose, V::DIM == 2)[0]),
        irradiance: rgb(choose.light()),
    };
    if choose.below(3) == 0 {
        scene.fog = Fog {
            region: round(choose, &mut known, 0),
            absorption: rgb(choose.light()),
            scattering: V::T::from_f64(choose.of(&[0.0, 1.0, 1e-6, 1e6])),
        };
    }
    scene.bounces = choose.of(&[0, 1, 2, 4, 16]);
    scene.combine = choose.of(&[
        Combine::Balance,
        Combine::Power,
        Combine::Light,
        Combine::Scatter,
    ]);
    scene.seed = choose.below(1 << 16) as u32;
    let law = law::<V>(choose);
    (scene, law)
}

/// Renders one, small.
///
/// # Errors
/// The first pixel that is no number.
pub fn rendered<V: World>(choose: &mut impl Choose, samples: u32) -> Result<(), String> {
    let (scene, law) = scene::<V>(choose);
    let e = Asked(scene.called_for());
    for y in 0..scene.camera.height {
        for x in 0..scene.camera.width {
            let pixel = pixel(&scene, e, &law, (x, y), samples, &mut ());
            let (mean, variance) = (pixel.mean(), pixel.variance());
            if !mean.iter().all(|m| m.is_finite()) || variance.iter().any(|v| v.is_nan()) {
                return Err(format!("pixel ({x}, {y}) is {mean:?}, {law:?}, {scene:#?}"));
            }
        }
    }
    Ok(())
}
