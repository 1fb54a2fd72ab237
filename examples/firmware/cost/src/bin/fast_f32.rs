//! `Fast<f32>`.
#![no_std]
#![no_main]

use coslobe::Fast;

#[board::entry]
fn main() -> ! {
    cost::run(cost::every_law::<Fast<f32>>)
}
