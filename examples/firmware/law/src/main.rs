//! One law in one number type prints a few directions: `cargo run -p law`. Which ones, `build.rs`
//! says.
#![no_std]
#![no_main]

use board::{Console, exit};
use kit::directions;

mod subject {
    include!(concat!(env!("OUT_DIR"), "/subject.rs"));
}

#[board::entry]
fn main() -> ! {
    exit(directions(&subject::subject(), &mut Console).is_ok())
}
