//! Start here: directions over defmt. `cargo run` shows them on an emulated Cortex-M4F.
#![no_std]
#![no_main]

use coslobe::{Ball, CircleShell, Disk, Lambert, Law, Spatial};
use defmt::info;
use defmt_semihosting as _; // carries what defmt logs to the emulator's output
use rand_pcg::Pcg32;

#[board::entry]
fn main() -> ! {
    // On a device the seed comes from its hardware: two devices with one seed draw the same
    // directions.
    let mut rng = Pcg32::new(2024, 1);

    info!("Planar laws: [sin θ, cos θ], θ from the axis");
    let disk: [f32; 2] = Disk.sample(&mut rng);
    let shell: [f32; 2] = CircleShell.sample(&mut rng);
    info!("Disk        {}", disk);
    info!("CircleShell {}", shell);

    info!("Spatial laws: [sin θ cos φ, cos θ, sin θ sin φ]");
    for _ in 0..4 {
        let d: [f32; 3] = Lambert.sample(&mut rng);
        info!("Lambert     {}", d);
    }
    let d: [f32; 3] = Ball.sample(&mut rng);
    info!("Ball        {}", d);
    let d: [f32; 3] = Lambert.sample_around([1.0, 0.0, 0.0], &mut rng);
    info!("Lambert     {} around +x", d);

    info!("Lambert at u = 0.25: {}", Lambert.warp(0.25f32));
    board::exit(true)
}
