//! How deep a call reaches into the stack, by painting it.

use core::arch::asm;
use core::ptr::{read_volatile, write_volatile};

/// Words that are painted below the caller's frame.
const DEPTH: usize = 1536;

/// Bytes of stack that `call` writes to, its own frame included.
///
/// Painted in two colours: a word that a call happens to leave in one of them it does not leave in
/// both. Needs an optimised build, in which this function keeps its loops to itself.
pub fn stack(call: &mut dyn FnMut()) -> usize {
    let first = painted(call, 0x5AA5_C33C);
    first.max(painted(call, 0xA55A_3CC3))
}

#[inline(never)]
fn painted(call: &mut dyn FnMut(), colour: u32) -> usize {
    let top: *mut u32;
    // SAFETY: reads the stack pointer.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) top, options(nomem, nostack, preserves_flags));
        #[cfg(target_arch = "riscv32")]
        asm!("mv {}, sp", out(reg) top, options(nomem, nostack, preserves_flags));
    }
    for i in 1..=DEPTH {
        // SAFETY: below the stack pointer nothing lives: this loop calls nothing, and no interrupt
        // is enabled. The boards have more RAM than this below their initial stack pointer.
        unsafe { write_volatile(top.wrapping_sub(i), colour) };
    }
    call();
    let mut deepest = DEPTH;
    // SAFETY: as above.
    while deepest > 0 && unsafe { read_volatile(top.wrapping_sub(deepest)) } == colour {
        deepest -= 1;
    }
    assert!(deepest < DEPTH, "a call used all of the painted stack");
    deepest * size_of::<u32>()
}
