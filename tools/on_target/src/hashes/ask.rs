//! Who answers requests for hashes: see `tests/kit/src/answer.rs`.

use crate::args::Hashes;
use crate::boards::Board;
use crate::build::Build;
use crate::failure::Result;
use crate::qemu::{self, Emulation};
use crate::{build, host};
use std::fs;
use std::path::PathBuf;
use std::time::Duration;

/// This machine or a board, for one number type.
pub(super) trait Asked {
    /// The lines of its answer.
    fn ask(&self, request: &[&str]) -> Result<String>;
}

/// This machine.
pub(super) struct Host<'a> {
    pub(super) number: &'a str,
}

impl Asked for Host<'_> {
    fn ask(&self, request: &[&str]) -> Result<String> {
        host::hashes(self.number, request)
    }
}

/// An image on its board.
pub(super) struct Device<'a> {
    board: &'a Board,
    image: PathBuf,
    timeout: Duration,
}

impl<'a> Device<'a> {
    /// Builds the image of a number type.
    pub(super) fn build(board: &'a Board, number: &str, options: &Hashes) -> Result<Self> {
        let build = Build {
            board,
            package: "hash",
            variables: vec![("COSLOBE_TYPE", number.to_owned())],
            features: if options.planted { &["planted"] } else { &[] },
            debug: options.debug,
        };
        let built = build.image()?;
        // A name of its own: a long run must not lose its image to the next build.
        let image = built.with_file_name(format!("hash-{}", build::file_name(number)));
        fs::copy(&built, &image).map_err(|e| crate::failure::Failure(e.to_string()))?;
        let hours = if options.full { 24 } else { 1 };
        Ok(Device {
            board,
            image,
            timeout: Duration::from_secs(hours * 3600),
        })
    }
}

impl Asked for Device<'_> {
    fn ask(&self, request: &[&str]) -> Result<String> {
        let emulation = Emulation {
            counts: false,
            timeout: self.timeout,
        };
        let output = qemu::run(self.board, &self.image, request, emulation)?;
        Ok(String::from_utf8_lossy(&output).into_owned())
    }
}
