//! The command line that the emulator passes on.

use semihosting::experimental::env::{Args, args};

/// Arguments of at most this many bytes together.
const LENGTH: usize = 128;

/// The words of the command line.
pub struct Arguments(Args<LENGTH>);

/// The command line; its first word is the image's name.
///
/// # Panics
/// If it is too long or the emulator has none.
pub fn arguments() -> Arguments {
    Arguments(args().expect("a command line of at most 128 bytes"))
}

impl Arguments {
    /// The next word.
    ///
    /// # Panics
    /// If it is not UTF-8.
    pub fn next(&self) -> Option<&str> {
        (&self.0).next().map(|word| word.expect("UTF-8"))
    }
}
