//! Scene files: whatever the bytes, an answer with a place or a scene that renders to numbers; and the bytes as
//! choices of a random scene, which does too.

use coslobe::{Fast, Precise};
use shade::file::{self, Raw, World};
use shade::random::{Choose, rendered};
use shade_core::{Asked, pixel};

pub fn check(data: &[u8]) {
    if let Ok(text) = std::str::from_utf8(data) {
        file(text);
    }
    let mut choices = Choices(data);
    let type_and_world = [
        rendered::<[f32; 2]>,
        rendered::<[f32; 3]>,
        rendered::<[Fast<f32>; 2]>,
        rendered::<[Fast<f32>; 3]>,
        rendered::<[Precise<f32>; 2]>,
        rendered::<[Precise<f32>; 3]>,
        rendered::<[f64; 2]>,
        rendered::<[f64; 3]>,
    ];
    let done = choices.of(&type_and_world)(&mut choices, 2);
    assert_eq!(done, Ok(()));
}

/// The input's bytes, two a choice, then zeros.
struct Choices<'a>(&'a [u8]);

impl Choose for Choices<'_> {
    fn below(&mut self, n: usize) -> usize {
        let (head, rest) = self.0.split_at(self.0.len().min(2));
        self.0 = rest;
        head.iter().fold(0, |word, &b| word << 8 | usize::from(b)) % n
    }
}

fn file(text: &str) {
    match file::parse("scene", text) {
        Ok(raw) if raw.flatland => render::<[f32; 2]>(&raw),
        Ok(raw) => render::<[f32; 3]>(&raw),
        Err(e) => {
            let message = e.to_string();
            let mut place = message.split(':').skip(1);
            let is_number = |part: Option<&str>| part.is_some_and(|p| p.parse::<usize>().is_ok());
            assert!(
                is_number(place.next()) && is_number(place.next()),
                "{message}"
            );
        }
    }
}

/// Four pixels of it, with few bounces.
fn render<V: World>(raw: &Raw) {
    let (mut scene, law) = file::scene::<V>(raw, None).expect("a checked scene is of its world");
    scene.bounces = scene.bounces.min(4);
    let (w, h) = (scene.camera.width, scene.camera.height);
    let set = scene.called_for();
    for at in [(0, 0), (w / 2, h / 2), (w - 1, 0), (w / 3, h - 1)] {
        let pixel = pixel(&scene, Asked(set), &law, at, 2, &mut ());
        let mean = pixel.mean();
        assert!(mean.iter().all(|x| x.is_finite()), "{at:?}: {mean:?}");
    }
}
