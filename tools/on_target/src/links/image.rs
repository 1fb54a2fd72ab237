//! Builds the firmware workspace's member `links`.

use super::elf::Image;
use crate::boards::Board;
use crate::build::Build;
use crate::failure::Result;
use std::path::PathBuf;

/// An image of `calls` (see `examples/firmware/links/build.rs`), and its path until the next is built.
/// Where a panic or an allocation is reachable, the linker's message is the error.
pub(super) fn build(board: &Board, calls: &str, planted: Option<&str>) -> Result<(PathBuf, Image)> {
    let features: Vec<&str> = planted.into_iter().collect();
    let path = Build {
        board,
        package: "links",
        variables: vec![("COSLOBE_CALLS", calls.to_owned())],
        features: &features,
        debug: false,
    }
    .image()?;
    let image = Image::read(&path)?;
    Ok((path, image))
}
