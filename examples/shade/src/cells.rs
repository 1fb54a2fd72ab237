//! What the table compares, scene by scene: the effects needed, all of them, and a shader written
//! by hand.

use crate::file::{World, parse, scene};
use crate::hand;
use crate::sets::{Compiled, Job};
use coslobe::{CircleShell, Lambert};
use shade_core::effect::Lamp;
use shade_core::{
    Asked, Counters, Effect, Effects, Pixel, Place, Sampling, Scene, Set, Vector, pixel,
};
use std::hint::black_box;
use std::rc::Rc;

/// A shipped scene.
pub struct Shipped {
    pub name: &'static str,
    pub text: &'static str,
}

/// The shipped scenes.
pub const SHIPPED: [Shipped; 12] = [
    Shipped {
        name: "emitter",
        text: include_str!("../scenes/emitter.toml"),
    },
    Shipped {
        name: "furnace",
        text: include_str!("../scenes/furnace.toml"),
    },
    Shipped {
        name: "gradient",
        text: include_str!("../scenes/gradient.toml"),
    },
    Shipped {
        name: "hard_shadow",
        text: include_str!("../scenes/hard_shadow.toml"),
    },
    Shipped {
        name: "soft_shadow",
        text: include_str!("../scenes/soft_shadow.toml"),
    },
    Shipped {
        name: "box",
        text: include_str!("../scenes/box.toml"),
    },
    Shipped {
        name: "gloss",
        text: include_str!("../scenes/gloss.toml"),
    },
    Shipped {
        name: "depth_of_field",
        text: include_str!("../scenes/depth_of_field.toml"),
    },
    Shipped {
        name: "fog",
        text: include_str!("../scenes/fog.toml"),
    },
    Shipped {
        name: "all",
        text: include_str!("../scenes/all.toml"),
    },
    Shipped {
        name: "flat_lamp",
        text: include_str!("../scenes/flat_lamp.toml"),
    },
    Shipped {
        name: "flat_bounces",
        text: include_str!("../scenes/flat_bounces.toml"),
    },
];

/// Pixels across and down that are counted, and samples of each.
const GRID: (u16, u16) = (16, 12);
const SAMPLES: u32 = 4;

/// The same pixels by one of the ways.
pub struct Cell {
    pub scene: &'static str,
    pub way: &'static str,
    pub run: Box<dyn FnMut()>,
    pub empty: Box<dyn FnMut()>,
    /// What it computes.
    pub pixels: Box<dyn Fn() -> Vec<Pixel<f32>>>,
    pub samples: u64,
    /// How many effects are on; rays and words a sample. Shaders written by hand do not say.
    pub effects: Option<u32>,
    pub rays: Option<f64>,
    pub words: Option<f64>,
}

fn grid<V: Vector>(scene: &Scene<V>) -> Vec<(u16, u16)> {
    let (w, h) = (scene.camera.width, scene.camera.height);
    let (dx, dy) = (w / GRID.0, h / GRID.1);
    let row = |y| (0..GRID.0).map(move |x| (x * dx + dx / 2, y * dy + dy / 2));
    (0..GRID.1).flat_map(row).collect()
}

fn cell(
    scene: &'static str,
    way: &'static str,
    at: Vec<(u16, u16)>,
    f: impl Fn((u16, u16)) -> Pixel<f32> + 'static,
) -> Cell {
    let (f, at) = (Rc::new(f), Rc::new(at));
    let (g, places, same) = (f.clone(), at.clone(), at.clone());
    Cell {
        scene,
        way,
        effects: None,
        rays: None,
        words: None,
        samples: at.len() as u64 * u64::from(SAMPLES),
        run: Box::new(move || {
            for &at in &*at {
                black_box(f(black_box(at)));
            }
        }),
        empty: Box::new(move || {
            for &at in &*same {
                black_box(at);
                black_box(Pixel::<f32>::default());
            }
        }),
        pixels: Box::new(move || places.iter().map(|&at| g(at)).collect()),
    }
}

struct Way<V: Vector, L> {
    scene: &'static str,
    way: &'static str,
    of: Rc<Scene<V>>,
    law: L,
}

impl<V: Vector<T = f32>, L: Sampling<V> + 'static> Job for Way<V, L> {
    type Out = Cell;
    fn run<E: Effects>(self, e: E) -> Cell {
        let Way {
            scene,
            way,
            of,
            law,
        } = self;
        let at = grid(&of);
        let mut n = Counters::default();
        for &at in &at {
            pixel(&of, Asked(e.set()), &law, at, SAMPLES, &mut n);
        }
        let samples = at.len() as f64 * f64::from(SAMPLES);
        let mean = |n: [u64; Effect::COUNT]| Some(n.iter().sum::<u64>() as f64 / samples);
        // A set that is asked must not be known to the compiler.
        let shade = move |at| pixel(&of, black_box(e), &law, at, SAMPLES, &mut ());
        Cell {
            effects: Some(e.set().iter().count() as u32),
            rays: mean(n.rays),
            words: mean(n.words),
            ..cell(scene, way, at, shade)
        }
    }
}

/// A shader of a pixel's samples.
fn of_pixels<V: Vector<T = f32>>(
    scene: &'static str,
    of: &Rc<Scene<V>>,
    shader: impl Fn(&Scene<V>, (u16, u16), u32) -> Pixel<f32> + 'static,
) -> Cell {
    let of = of.clone();
    cell(scene, "hand", grid(&of), move |at| {
        let i = u32::from(at.1) * u32::from(of.camera.width) + u32::from(at.0);
        shader(&of, at, i)
    })
}

/// A shader of one sample.
fn of_samples<V: Vector<T = f32>>(
    scene: &'static str,
    of: &Rc<Scene<V>>,
    f: impl Fn(&Scene<V>, (u16, u16), Place) -> [f32; 3] + 'static,
) -> Cell {
    of_pixels(scene, of, move |scene, at, i| {
        Pixel::collect(i, scene.seed, SAMPLES, |place| f(scene, at, place))
    })
}

fn ways<V: World<T = f32> + Compiled, L: Sampling<V> + 'static>(
    cells: &mut Vec<Cell>,
    shipped: &Shipped,
    law: L,
) -> Option<Rc<Scene<V>>> {
    let raw = parse(shipped.name, shipped.text).ok()?;
    let (mut forced, _) = scene::<V>(&raw, None)?;
    let of = Rc::new(forced.clone());
    if forced.lamps.is_empty() {
        forced.lamps.push(Lamp::neutral()).ok()?;
    }
    let forced = Rc::new(forced);
    let needed = of.called_for();
    let way = |way, of: &Rc<Scene<V>>| Way {
        scene: shipped.name,
        way,
        of: of.clone(),
        law,
    };
    cells.push(V::exactly(needed, way("needed", &of)));
    cells.push(way("asked", &of).run(Asked(needed)));
    cells.push(V::exactly(Set::ALL, way("all", &forced)));
    Some(of)
}

/// All ways of all shipped scenes, in `f32`.
pub fn cells() -> Vec<Cell> {
    let mut cells = Vec::new();
    for shipped in &SHIPPED {
        if shipped.name.starts_with("flat") {
            let Some(of) = ways::<[f32; 2], _>(&mut cells, shipped, CircleShell) else {
                continue;
            };
            cells.push(match shipped.name {
                "flat_lamp" => of_samples(shipped.name, &of, hand::flat_lamp),
                _ => of_samples(shipped.name, &of, hand::flat_bounces),
            });
            continue;
        }
        let Some(of) = ways::<[f32; 3], _>(&mut cells, shipped, Lambert) else {
            continue;
        };
        let name = shipped.name;
        cells.push(match name {
            "emitter" => of_pixels(name, &of, |scene, at, i| {
                Pixel::collect(i, scene.seed, SAMPLES, hand::emitter(scene, at))
            }),
            "furnace" => of_pixels(name, &of, |scene, at, i| {
                Pixel::collect(i, scene.seed, SAMPLES, hand::furnace(scene, at))
            }),
            "gradient" => of_samples(name, &of, hand::gradient),
            "hard_shadow" => of_samples(name, &of, hand::hard_shadow),
            "soft_shadow" => of_samples(name, &of, hand::soft_shadow),
            "box" => of_samples(name, &of, hand::interior),
            "gloss" => of_samples(name, &of, hand::gloss),
            "depth_of_field" => of_samples(name, &of, hand::depth_of_field),
            "fog" => of_samples(name, &of, hand::fog),
            _ => continue,
        });
    }
    cells
}
