//! Power-on: is the generator sound, and do the samplers yield their laws? `cargo run -p self_test`
//! checks a good generator; `cargo run -p self_test stuck` one that is stuck. The cases are in the
//! kit.
#![no_std]
#![no_main]

use core::hint::black_box;
use coslobe::self_test::{self, Alarm, Subject, Test};
use coslobe::{Fixed, Lambert, Spatial};
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
    if case == "cost"
        && let Some(rng) = cases::generator("good")
    {
        info!("instructions a sample: {}", instructions(rng.clone()));
        let test = || self_test::spatial::<f32, _>(Lambert);
        info!("bytes of stack: {}", stack(test, rng.clone()));
        let test = || self_test::fixed(Fixed(Lambert));
        info!("bytes of stack in integers: {}", stack(test, rng));
    }
    board::exit(verdict.is_ok())
}

/// Instructions of the checked and counted sample beyond those of the sample alone.
fn instructions(mut rng: cases::Generator) -> u32 {
    const N: u16 = 4096;
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
    (more / 2 / u64::from(N)) as u32
}

/// The deepest of a whole test, itself included.
fn stack<S: Subject>(test: impl Fn() -> Test<S>, mut rng: cases::Generator) -> usize {
    board::stack(&mut || {
        let mut test = test();
        test.run(&mut rng, self_test::SAMPLES);
        let _ = black_box(test.verdict(Alarm::OneInBillion));
    })
}
