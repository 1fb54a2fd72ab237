//! `libm` in `f32`.
#![no_std]
#![no_main]

use cost::peers;

#[board::entry]
fn main() -> ! {
    cost::run(peers::every_law::<kit::formulas::Libm>)
}
