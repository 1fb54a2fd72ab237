//! A direction in each of our number types.
#![no_std]
#![no_main]

#[board::entry]
fn main() -> ! {
    cost::run(cost::every_direction)
}
