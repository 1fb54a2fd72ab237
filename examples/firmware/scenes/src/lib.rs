//! Small scenes, each with the effects that it calls for as part of its type: what another effect
//! would take is not compiled. Firmware renders them and prints the pixels' bits; the host does the
//! same and compares.
#![no_std]
#![forbid(unsafe_code)]

mod contents;
mod frame;

pub use frame::{Frame, HEIGHT, SAMPLES, WIDTH, words};

use core::marker::PhantomData;
use coslobe::{CircleShell, Lambert};
use shade_core::Effect::{
    Absorption, Bounces, Diffuse, Emission, Filter, Gloss, Lamp, Lens, Mix, Scattering, Sky, Sun,
};
use shade_core::effect::Lamp as Light;
use shade_core::{Effects, Only, Sampling, Scene, Set, Vector};

/// A scene.
pub trait Small {
    /// As the table names it.
    const NAME: &'static str;
    /// Space or flatland.
    type World: Vector<T = f32>;
    /// The law of diffuse reflection there.
    type Law: Sampling<Self::World> + Default;
    /// Exactly the effects that it calls for.
    type Effects: Effects + Default;
    /// What it holds.
    fn scene() -> Scene<Self::World>;
}

/// Is shown scenes.
pub trait Visitor {
    /// Looks at one; `name` is its type's.
    fn visit<S: Small>(&mut self, name: &'static str);
}

/// How many scenes there are.
pub const SCENES: usize = 9;

/// Shows every scene.
pub fn each(visitor: &mut impl Visitor) {
    visitor.visit::<Emitter>("Emitter");
    visitor.visit::<OpenSky>("OpenSky");
    visitor.visit::<HardShadow>("HardShadow");
    visitor.visit::<SoftShadow>("SoftShadow");
    visitor.visit::<Glossy>("Glossy");
    visitor.visit::<Hazy>("Hazy");
    visitor.visit::<Focused>("Focused");
    visitor.visit::<Everything>("Everything");
    visitor.visit::<Flatland>("Flatland");
}

/// A ball that shines.
pub struct Emitter;
/// A ball on a floor under a graded sky.
pub struct OpenSky;
/// And a sun.
pub struct HardShadow;
/// And a lamp.
pub struct SoftShadow;
/// And a glossy ball.
pub struct Glossy;
/// And fog that absorbs.
pub struct Hazy;
/// And a lens.
pub struct Focused;
/// And all that is left.
pub struct Everything;
/// Two dimensions: a circle and a floor under a sky and a lamp.
pub struct Flatland;
/// A scene with every effect forced on: the same pixels.
pub struct Forced<S>(PhantomData<S>);

impl Small for Emitter {
    const NAME: &'static str = "a bare emitter";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Emission]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::emitter()
    }
}

impl Small for OpenSky {
    const NAME: &'static str = "sky, diffuse";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Sky, Diffuse]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::open_sky()
    }
}

impl Small for HardShadow {
    const NAME: &'static str = "+ hard shadow";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Sky, Diffuse, Sun]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::hard_shadow()
    }
}

impl Small for SoftShadow {
    const NAME: &'static str = "+ soft shadow";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Sky, Diffuse, Sun, Lamp]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::soft_shadow()
    }
}

impl Small for Glossy {
    const NAME: &'static str = "+ gloss";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Sky, Diffuse, Sun, Lamp, Gloss]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::glossy()
    }
}

impl Small for Hazy {
    const NAME: &'static str = "+ fog that absorbs";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Sky, Diffuse, Sun, Lamp, Gloss, Absorption]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::hazy()
    }
}

impl Small for Focused {
    const NAME: &'static str = "+ lens";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<{ Set::of(&[Sky, Diffuse, Sun, Lamp, Gloss, Absorption, Lens]) }>;
    fn scene() -> Scene<[f32; 3]> {
        contents::focused()
    }
}

impl Small for Everything {
    const NAME: &'static str = "everything";
    type World = [f32; 3];
    type Law = Lambert;
    type Effects = Only<
        {
            Set::of(&[
                Filter, Lens, Sky, Emission, Sun, Lamp, Diffuse, Gloss, Mix, Bounces, Absorption,
                Scattering,
            ])
        },
    >;
    fn scene() -> Scene<[f32; 3]> {
        contents::everything()
    }
}

impl Small for Flatland {
    const NAME: &'static str = "flatland: sky, diffuse, soft shadow";
    type World = [f32; 2];
    type Law = CircleShell;
    type Effects = Only<{ Set::of(&[Sky, Diffuse, Lamp]) }>;
    fn scene() -> Scene<[f32; 2]> {
        contents::flatland()
    }
}

impl<S: Small> Small for Forced<S> {
    const NAME: &'static str = S::NAME;
    type World = S::World;
    type Law = S::Law;
    type Effects = Only<{ Set::ALL.0 }>;
    fn scene() -> Scene<S::World> {
        let mut scene = S::scene();
        if scene.lamps.is_empty() {
            // There is room: it is empty.
            let _ = scene.lamps.push(Light::neutral());
        }
        scene
    }
}
