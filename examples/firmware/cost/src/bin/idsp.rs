//! `idsp` in integers.
#![no_std]
#![no_main]

#[board::entry]
fn main() -> ! {
    cost::run(cost::peers::idsp)
}
