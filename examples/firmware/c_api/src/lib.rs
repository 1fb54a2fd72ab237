//! coslobe for C. The header, coslobe.h, says what each function takes and returns.
//!
//! What is unsafe is in boundary.rs: a generator behind a function pointer, and one write through a
//! pointer. The library itself has none.
#![no_std]

pub mod boundary;
pub mod f32;
pub mod q31;

/// Panics where no one looks: the proof that no panic is linked has to find it.
/// cbindgen:ignore
#[cfg(planted)]
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_planted(i: u32) -> u32 {
    [1, 2, 3][i as usize]
}

/// Nothing in the library panics, so this is not linked into a program; a static library must have it.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
