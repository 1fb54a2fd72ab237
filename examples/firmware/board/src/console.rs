//! Text output.

use core::fmt::{self, Write};
use semihosting::print;

/// The emulator's standard output.
pub struct Console;

impl Write for Console {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        print!("{text}");
        Ok(())
    }
}
