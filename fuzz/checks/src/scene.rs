//! Scene files: whatever the bytes, an answer with a place or a scene that renders to numbers; and
//! the bytes as choices of a random scene, which does too.

use shade::file::{self, Raw, World};
use shade::random::{Choose, rendered};
use shade_core::{Asked, Number, NumberVisitor, every_number, pixel};

pub fn check(data: &[u8]) {
    if let Ok(text) = std::str::from_utf8(data) {
        file(text);
    }
    let mut choices = Choices(data);
    let mut types = Types(Vec::new());
    every_number(&mut types);
    let done = choices.of(&types.0)(&mut choices, 2);
    assert_eq!(done, Ok(()));
}

/// What renders a random scene of flatland or of space in each number type.
struct Types<'a>(Vec<Rendered<'a>>);

type Rendered<'a> = fn(&mut Choices<'a>, u32) -> Result<(), String>;

impl NumberVisitor for Types<'_> {
    fn number<T: Number>(&mut self) {
        self.0.extend([rendered::<[T; 2]>, rendered::<[T; 3]>]);
    }
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
