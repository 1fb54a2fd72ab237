//! Scene files: whatever the bytes, an answer with a place or a scene that renders.

use shade::file::{self, Raw, World};
use shade_core::{Asked, pixel};

pub fn check(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
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
        assert_eq!(pixel.count, 2);
    }
}
