//! `Fixed16`, in integers of 16 bits.
#![no_std]
#![no_main]

#[board::entry]
fn main() -> ! {
    cost::run(cost::every_fixed16_law)
}
