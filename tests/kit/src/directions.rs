//! A few directions, as the smallest firmware prints them.

use crate::stream::Walk;
use crate::{Hash, Sink, Stream, Subject};
use core::fmt::{self, Write};

/// Directions that are printed.
const PRINTED: u32 = 4;
/// Directions that are hashed.
const HASHED: u32 = 64;

/// Prints the bits of the first samples, and the hash of some more: the first checkpoint's.
///
/// # Errors
/// If `out` cannot be written to.
pub fn directions<S: Subject>(subject: &S, out: &mut impl Write) -> fmt::Result {
    let mut walk = Walk::new(subject, Stream::Samples);
    for index in 1..=PRINTED {
        write!(out, "{} {}:", S::LAW, S::NUMBER)?;
        let mut bits = Bits(out, Ok(()));
        walk.walk_to(index, &mut bits);
        bits.1?;
        writeln!(out)?;
    }
    let mut hash = Hash::default();
    Walk::new(subject, Stream::Samples).walk_to(HASHED, &mut hash);
    writeln!(
        out,
        "{} {} hash of {HASHED}: {:016x}",
        S::LAW,
        S::NUMBER,
        hash.value()
    )
}

struct Bits<'a, W>(&'a mut W, fmt::Result);

impl<W: Write> Sink for Bits<'_, W> {
    const NAMES_INPUTS: bool = false;

    fn take(&mut self, name: &'static str, bits: u64) {
        if self.1.is_ok() {
            self.1 = write!(self.0, " {name} = {bits:#x}");
        }
    }
}
