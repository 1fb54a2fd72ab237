//! Hashes of every law in one number type: `cargo run -p hash -- all samples checkpoints 4096`.
#![no_std]
#![no_main]

use board::{Console, arguments, exit};
use kit::{Answer, answer};

mod number {
    include!(concat!(env!("OUT_DIR"), "/number.rs"));
}

#[board::entry]
fn main() -> ! {
    let arguments = arguments();
    let _image = arguments.next();
    let words = core::iter::from_fn(|| arguments.next());
    exit(answer::<number::Number>(words, &mut Console) == Ok(Answer::Done))
}
