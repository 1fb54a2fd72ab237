//! Builds the firmware workspace's member `links`.

use super::elf::Image;
use crate::boards::Board;
use crate::build::Build;
use crate::failure::Result;
use std::path::PathBuf;

/// An image of `calls` (see `examples/firmware/links/build.rs`), and its path until the next is
/// built. Where a panic or an allocation is reachable, the linker's message is the error.
pub(super) fn build(board: &Board, calls: &str, planted: Option<&str>) -> Result<(PathBuf, Image)> {
    build_as(board, calls, planted, Vec::new())
}

/// The same with settings of the profile, as cargo's environment variables.
pub(super) fn build_as(
    board: &Board,
    calls: &str,
    planted: Option<&str>,
    settings: Vec<(&'static str, String)>,
) -> Result<(PathBuf, Image)> {
    let features: Vec<&str> = planted.into_iter().collect();
    let mut variables = settings;
    variables.push(("COSLOBE_CALLS", calls.to_owned()));
    let path = Build {
        board,
        package: "links",
        variables,
        features: &features,
        debug: false,
    }
    .image()?;
    let image = Image::read(&path)?;
    Ok((path, image))
}
