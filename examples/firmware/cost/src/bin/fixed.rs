//! `Fixed`, in integers alone.
#![no_std]
#![no_main]

#[board::entry]
fn main() -> ! {
    cost::run(cost::every_fixed_law)
}
