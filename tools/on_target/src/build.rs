//! Builds images of the firmware workspace.

use crate::boards::Board;
use crate::failure::{Failure, Result, While};
use std::path::{Path, PathBuf};
use std::process::Command;

/// An image to build.
pub(crate) struct Build<'a> {
    pub(crate) board: &'a Board,
    /// The workspace's member.
    pub(crate) package: &'a str,
    /// What its build script reads, or cargo instead of the profile's settings.
    pub(crate) variables: Vec<(&'static str, String)>,
    pub(crate) features: &'a [&'a str],
    pub(crate) debug: bool,
}

/// This repository.
pub(crate) fn root() -> &'static Path {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    tools
        .and_then(Path::parent)
        .expect("tools/on_target is below the root")
}

/// The firmware workspace.
pub(crate) fn workspace() -> PathBuf {
    root().join("examples/firmware")
}

impl Build<'_> {
    /// The image's path; the next build of the package overwrites it.
    pub(crate) fn image(&self) -> Result<PathBuf> {
        let profile = if self.debug { "dev" } else { "release" };
        // One a board, so that boards can be built side by side.
        let folder = root().join("target/on_target").join(self.board.name);
        let mut command = Command::new("cargo");
        command
            .current_dir(workspace())
            .args(["build", "--quiet", "--profile", profile])
            .args(["--package", self.package, "--target", self.board.target])
            .arg("--target-dir")
            .arg(&folder)
            // Of the cargo that runs this program; they would be read as the user's.
            .env_remove("CARGO_MANIFEST_DIR")
            .env_remove("RUSTFLAGS");
        if !self.features.is_empty() {
            command.arg("--features").arg(self.features.join(","));
        }
        if let (Some(level), false) = (self.board.opt_level, self.debug) {
            command.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level);
        }
        command.envs(self.variables.iter().map(|(k, v)| (k, v)));
        let built = command.output().while_("starting cargo")?;
        if !built.status.success() {
            let errors = String::from_utf8_lossy(&built.stderr).into_owned();
            return Err(Failure(errors));
        }
        let profile = if self.debug { "debug" } else { "release" };
        Ok(folder
            .join(self.board.target)
            .join(profile)
            .join(self.package))
    }
}

/// A name without the characters of generic types.
pub(crate) fn file_name(name: &str) -> String {
    name.replace(['<', '>'], "-")
        .trim_end_matches('-')
        .to_lowercase()
}
