//! Blocks of pixels on all threads. What a pixel is does not depend on who renders it.

use crate::args::Share;
use crate::image::Frame;
use indicatif::ProgressBar;
use rayon::prelude::*;
use shade_core::{Effects, Pixel, Sampling, Scene, Vector, pixel};

/// The pixels of one share of the frame.
pub(crate) fn render<V: Vector, E: Effects, L: Sampling<V>>(
    scene: &Scene<V>,
    e: E,
    law: &L,
    samples: u32,
    share: Share,
    progress: &ProgressBar,
) -> Frame {
    let mut frame = Frame::new(scene.camera.width, scene.camera.height);
    let blocks: Vec<u32> = frame.blocks_of(share).collect();
    progress.set_length(blocks.len() as u64);
    let done: Vec<(u32, Vec<Pixel<f64>>)> = blocks
        .into_par_iter()
        .map(|block| {
            let places = frame.places(block);
            let pixels = places.map(|at| pixel(scene, e, law, at, samples, &mut ()).wide());
            let pixels = pixels.collect();
            progress.inc(1);
            (block, pixels)
        })
        .collect();
    for (block, pixels) in done {
        frame.put(block, &pixels);
    }
    frame
}
