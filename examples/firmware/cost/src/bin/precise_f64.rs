//! `Precise<f64>`.
#![no_std]
#![no_main]

use coslobe::Precise;

#[board::entry]
fn main() -> ! {
    cost::run(cost::every_law::<Precise<f64>>)
}
