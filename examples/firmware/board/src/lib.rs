//! What depends on the board: start-up, panic, output and exit by semihosting, a counter of
//! instructions.
//!
//! The rest of the firmware has no `unsafe` and does not know where it runs:
//!
//! ```ignore
//! #[board::entry]
//! fn main() -> ! {
//!     board::println!("{}", board::Ticks::start().elapsed());
//!     board::exit(true)
//! }
//! ```
//!
//! A binary links with `-Tboard.x`, which this crate's `build.rs` writes.
#![no_std]

mod arguments;
mod console;
mod stack;
mod ticks;

pub use arguments::{Arguments, arguments};
pub use console::Console;
#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;
pub use semihosting::{print, println};
pub use stack::stack;
pub use ticks::Ticks;

use core::panic::PanicInfo;
use semihosting::process;

/// Ends the emulation, with exit code 0 or 1.
pub fn exit(success: bool) -> ! {
    process::exit(i32::from(!success))
}

/// On the error stream, so that what defmt prints stays whole.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    semihosting::eprintln!("{info}");
    process::exit(101)
}
