//! `f32`.
#![no_std]
#![no_main]

#[board::entry]
fn main() -> ! {
    cost::run(cost::every_law::<f32>)
}
