//! What the scenes hold: in space each is the one before and something more.

use crate::{HEIGHT, WIDTH};
use coslobe::CosPower;
use shade_core::effect::{Fog, Lamp, Sky, Sun};
use shade_core::{AnyPlanar, AnySpatial, Camera, Material, Plate, Rgb, Scene, Sphere, Vector};

type Space = Scene<[f32; 3]>;

const BLACK: Rgb<f32> = [0.0; 3];

/// From z = 4 towards −z.
fn camera() -> Camera<[f32; 3]> {
    Camera {
        eye: [0.0, 0.75, 4.0],
        right: [1.0, 0.0, 0.0],
        up: [0.0, 1.0, 0.0],
        forward: [0.0, 0.0, -1.0],
        step: 0.05,
        width: WIDTH,
        height: HEIGHT,
        filter: 0.0,
        lens: 0.0,
        focus: 4.0,
    }
}

// The lists have room for what is pushed here, as the effects called for show.

fn material<V: Vector<T = f32>>(scene: &mut Scene<V>, material: Material<V>) -> u8 {
    let _ = scene.materials.push(material);
    scene.materials.len() as u8 - 1
}

fn ball<V: Vector<T = f32>>(scene: &mut Scene<V>, centre: V, radius: f32, material: u8) {
    let _ = scene.spheres.push(Sphere {
        centre,
        radius,
        material,
    });
}

fn lamp<V: Vector<T = f32>>(scene: &mut Scene<V>, centre: V, radius: f32, radiance: Rgb<f32>) {
    let shape = Sphere {
        centre,
        radius,
        material: 0,
    };
    let _ = scene.lamps.push(Lamp { shape, radiance });
}

pub(crate) fn emitter() -> Space {
    let mut scene = Scene::new(camera());
    scene.bounces = 0;
    let glow = Material::new(BLACK, BLACK, AnySpatial::Lambert, [1.0, 0.8, 0.5]);
    let glow = material(&mut scene, glow);
    ball(&mut scene, [0.0, 0.7, 0.0], 0.7, glow);
    scene
}

pub(crate) fn open_sky() -> Space {
    let mut scene = Scene::new(camera());
    scene.sky = Sky {
        nadir: [0.05, 0.05, 0.06],
        zenith: [0.4, 0.5, 0.8],
    };
    let diffuse = |albedo| Material::new(albedo, BLACK, AnySpatial::Lambert, BLACK);
    let floor = material(&mut scene, diffuse([0.6, 0.6, 0.55]));
    let red = material(&mut scene, diffuse([0.7, 0.2, 0.15]));
    let _ = scene.plates.push(Plate {
        centre: [0.0; 3],
        normal: [0.0, 1.0, 0.0],
        axes: [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        half: [10.0, 10.0],
        material: floor,
    });
    ball(&mut scene, [-0.4, 0.6, 0.0], 0.6, red);
    scene
}

pub(crate) fn hard_shadow() -> Space {
    let mut scene = open_sky();
    scene.sun = Sun {
        towards: [0.64, 0.6, 0.48],
        irradiance: [1.6, 1.4, 1.0],
    };
    scene
}

pub(crate) fn soft_shadow() -> Space {
    let mut scene = hard_shadow();
    lamp(&mut scene, [-1.2, 2.4, 1.2], 0.4, [9.0, 8.0, 7.0]);
    scene
}

pub(crate) fn glossy() -> Space {
    let mut scene = soft_shadow();
    let lobe = CosPower::new(32.0).map_or(AnySpatial::Ball, AnySpatial::Power);
    let metal = Material::new(BLACK, [0.85, 0.8, 0.7], lobe, BLACK);
    let metal = material(&mut scene, metal);
    ball(&mut scene, [0.8, 0.45, 0.3], 0.45, metal);
    scene
}

pub(crate) fn hazy() -> Space {
    let mut scene = glossy();
    scene.fog = Fog {
        region: Sphere {
            centre: [0.0; 3],
            radius: 3.0,
            material: 0,
        },
        absorption: [0.05, 0.05, 0.03],
        scattering: 0.0,
    };
    scene
}

pub(crate) fn focused() -> Space {
    let mut scene = hazy();
    scene.camera.lens = 0.08;
    scene
}

pub(crate) fn everything() -> Space {
    let mut scene = focused();
    scene.bounces = 4;
    scene.camera.filter = 1.0;
    scene.fog.scattering = 0.06;
    let glazed = [0.5, 0.12, 0.08];
    let glazed = Material::new(glazed, [0.4; 3], AnySpatial::SphereShell, BLACK);
    let glazed = material(&mut scene, glazed);
    let glow = Material::new(BLACK, BLACK, AnySpatial::Lambert, [0.3, 1.6, 0.9]);
    let glow = material(&mut scene, glow);
    ball(&mut scene, [0.2, 0.25, 1.0], 0.25, glazed);
    ball(&mut scene, [0.7, 0.15, 1.2], 0.15, glow);
    scene
}

pub(crate) fn flatland() -> Scene<[f32; 2]> {
    let mut scene = Scene::new(Camera {
        eye: [0.0, 0.6],
        right: [1.0, 0.0],
        up: [0.0, 1.0],
        forward: [0.0, 0.0],
        step: 0.15,
        width: WIDTH,
        height: HEIGHT,
        filter: 0.0,
        lens: 0.0,
        focus: 1.0,
    });
    scene.sky = Sky {
        nadir: BLACK,
        zenith: [0.3, 0.5, 0.9],
    };
    let grey = Material::new([0.7; 3], BLACK, AnyPlanar::CircleShell, BLACK);
    let grey = material(&mut scene, grey);
    let _ = scene.plates.push(Plate {
        centre: [0.0, -0.2],
        normal: [0.0, 1.0],
        axes: [[1.0, 0.0], [0.0, 0.0]],
        half: [1.1, 0.0],
        material: grey,
    });
    ball(&mut scene, [0.2, 0.35], 0.3, grey);
    lamp(&mut scene, [-0.7, 1.1], 0.15, [6.0, 5.0, 4.0]);
    scene
}
