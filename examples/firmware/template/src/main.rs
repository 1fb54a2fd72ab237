//! A self-test at power-on, a hardware generator that fails once, and a lobe around a normal, in
//! integers alone.
#![no_std]
#![no_main]

mod device;

use core::panic::PanicInfo;
use coslobe::integers::FixedFrame;
use coslobe::self_test::{self, Alarm};
use coslobe::{Fixed, Lambert};
use cortex_m as _; // its critical sections
use cortex_m_rt::entry;
use device::{Device, NotReady};
use fixed::types::I1F31;
use rand_pcg::Pcg32;
use semihosting::{println, process};

#[entry]
fn main() -> ! {
    let mut device = Device::new();
    let law = Fixed(Lambert);

    // The hardware gives a seed; what draws the many words of the test is made of it.
    let seed = loop {
        match device.word() {
            Ok(word) => break u64::from(word),
            Err(NotReady) => println!("The generator is not ready: asked again."),
        }
    };
    let mut rng = Pcg32::new(seed, 1);
    let mut test = self_test::fixed(law);
    test.run(&mut rng, self_test::SAMPLES);
    match test.verdict(Alarm::OneInBillion) {
        Ok(report) => println!("Self-test passed: {} directions.", report.samples),
        Err(fault) => {
            println!("Self-test failed: {fault}");
            process::exit(1)
        }
    }

    // Straight from the hardware: an error is handed on, and no direction is made of half the
    // words.
    device.fail_once();
    for _ in 0..2 {
        match law.try_sample(&mut device) {
            Ok([x, y, z]) => println!("Drawn: {x:.6} {y:.6} {z:.6}"),
            Err(NotReady) => println!("Not drawn: the generator is not ready."),
        }
    }

    // Around a normal that has to be a unit vector; FixedFrame::new says if it is none.
    let normal = [I1F31::lit("0.6"), I1F31::ZERO, I1F31::lit("-0.8")];
    match FixedFrame::new(normal) {
        Ok(frame) => {
            let [x, y, z] = frame.to_world(law.sample(&mut rng));
            println!("Around the normal: {x:.6} {y:.6} {z:.6}");
            process::exit(0)
        }
        Err(error) => {
            println!("{error}");
            process::exit(1)
        }
    }
}

#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    println!("{info}");
    process::exit(101)
}
