//! coslobe for C. The header, include/coslobe.h, says what each function takes and returns.
//!
//! Where C's pointers are followed is boundary.rs. The functions are made by build.rs from the
//! table in surface/; the crate below has no unsafe code.
#![cfg_attr(target_os = "none", no_std)]

mod boundary;
#[allow(clippy::missing_safety_doc, clippy::undocumented_unsafe_blocks)] // boundary.rs says it once
mod shims {
    include!(concat!(env!("OUT_DIR"), "/shims.rs"));
}

/// Panics where no one looks: the proof that no panic is linked has to find it.
#[cfg(planted)]
#[unsafe(no_mangle)]
pub extern "C" fn coslobe_planted(i: u32) -> u32 {
    [1, 2, 3][i as usize]
}

/// Nothing in the library panics, so no program links this; a static library must have it.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
