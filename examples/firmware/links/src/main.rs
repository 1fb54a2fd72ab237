//! An image of operations and nothing else: no board, no start-up code, no output. It links only if
//! neither a panic nor an allocation is reachable, since both call symbols that exist nowhere; what
//! else it must not have, `on_target links` looks for. Not meant to run.
#![no_std]
#![no_main]

mod forbidden;
mod planted;

mod calls {
    include!(concat!(env!("OUT_DIR"), "/calls.rs"));
}

use links::operations::Words;

/// The image's entry. Words in and out: a float would be moved by the FPU.
// SAFETY: no other symbol of this name is linked.
#[unsafe(no_mangle)]
pub extern "C" fn _start(x: u32, seed: u32) -> u32 {
    let mut rng = Words(seed);
    planted::planted(calls::calls(x, &mut rng), seed)
}
