//! Power-on: is the generator sound, and do the samplers yield their laws? `cargo run -p self_test` checks
//! a good generator; `cargo run -p self_test stuck` one that is stuck. The cases are in the kit.
#![no_std]
#![no_main]

use defmt::{error, info};
use defmt_semihosting as _; // carries what defmt logs to the emulator's output
use kit::self_test as cases;

#[board::entry]
fn main() -> ! {
    let arguments = board::arguments();
    arguments.next(); // the image's name
    let case = arguments.next().unwrap_or("good");
    let Some(verdict) = cases::verdict(case) else {
        error!("no case {=str}; expected one of {}", case, cases::NAMES);
        board::exit(false)
    };
    match verdict {
        Ok(report) => info!("passed: {}", report),
        Err(fault) => error!("failed: {}", fault),
    }
    if let Some(cost) = cost(case) {
        info!("instructions a sample: {}", cost);
    }
    board::exit(verdict.is_ok())
}

/// Instructions of the checked and counted sample beyond those of the sample alone.
fn cost(case: &str) -> Option<u32> {
    use core::hint::black_box;
    use coslobe::{Lambert, Spatial, self_test};
    const N: u16 = 4096;
    if case != "cost" {
        return None;
    }
    let mut rng = cases::generator("good")?;
    let mut ticks = board::Ticks::start();
    for _ in 0..N {
        black_box::<[f32; 3]>(Spatial::sample(black_box(&Lambert), &mut rng));
    }
    let alone = ticks.elapsed();
    let mut test = self_test::spatial::<f32, _>(Lambert);
    ticks.restart();
    test.run(&mut rng, N);
    let checked = ticks.elapsed();
    black_box(&test);
    let more = u64::from(checked - alone) * u64::from(board::Ticks::INSTRUCTIONS_IN_TWO);
    Some((more / 2 / u64::from(N)) as u32)
}
