//! Renders one small scene and prints the bits of its pixels, and how many instructions that took:
//! `cargo run -p shade`. Which scene, `build.rs` says.
#![no_std]
#![no_main]

use board::{Console, Ticks, exit, println};
use core::hint::black_box;
use scenes::{Frame, Small};

mod scene {
    include!(concat!(env!("OUT_DIR"), "/scene.rs"));
}
use scene::Chosen;

#[board::entry]
fn main() -> ! {
    let mut ticks = Ticks::start();
    let mut frame = Frame::new();
    let scene = Chosen::scene();
    // Known to the compiler, it would be compiled into the integrator.
    let scene = black_box(&scene);
    ticks.restart();
    frame.render::<Chosen>(scene);
    let elapsed = black_box(&mut ticks).elapsed();
    let written = frame.write::<Chosen>(&mut Console);
    let instructions = u64::from(elapsed) * u64::from(Ticks::INSTRUCTIONS_IN_TWO) / 2;
    println!("instructions {instructions}");
    exit(written.is_ok())
}
