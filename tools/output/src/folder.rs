//! A folder of files that appear whole or not at all.

use crate::{File, plain};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use tempfile::{Builder, TempDir};

/// Files on their way; dropped before [`Folder::publish`] they leave no trace.
#[derive(Debug)]
pub struct Folder {
    target: PathBuf,
    files: Vec<(String, Vec<u8>)>,
}

fn wrong(path: &Path, what: impl std::fmt::Display) -> String {
    format!("--out: {}: {what}", plain(path.display()))
}

impl Folder {
    /// The folder at `target`, of which files of these names will be written. Checked before the
    /// work starts.
    ///
    /// # Errors
    /// If the target or a folder above it is a file or may not be written to, or one of the names
    /// cannot be.
    pub fn check<'n>(
        target: &Path,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Result<Folder, String> {
        let above = target.ancestors().find(|path| path.exists());
        let above = above.unwrap_or(Path::new("."));
        if !above.is_dir() {
            return Err(wrong(above, "is a file; expected a folder"));
        }
        within(above).map_err(|e| wrong(above, format_args!("cannot be written to: {e}")))?;
        if target.exists() {
            for name in names {
                File::check(&target.join(name), &[]).map_err(|e| format!("--out: {e}"))?;
            }
        }
        Ok(Folder {
            target: target.to_owned(),
            files: Vec::new(),
        })
    }

    /// One more file.
    pub fn add(&mut self, name: impl Into<String>, content: impl Into<Vec<u8>>) {
        self.files.push((name.into(), content.into()));
    }

    /// Puts the files in place. Other files of the target stay.
    ///
    /// # Errors
    /// If that fails.
    pub fn publish(self) -> Result<(), String> {
        let told = |e| format!("--out: {e}");
        if self.target.exists() {
            // All that can be known is asked before the first file is written.
            let files = self.files.iter().map(|(name, data)| {
                let file = File::check(&self.target.join(name), &[]).map_err(told)?;
                Ok((file, data))
            });
            let files: Result<Vec<_>, String> = files.collect();
            return files?
                .into_iter()
                .try_for_each(|(file, data)| file.write(data).map_err(told));
        }
        self.publish_whole()
            .map_err(|e| wrong(&self.target, format_args!("cannot be written: {e}")))
    }

    /// All at once, by renaming a folder.
    fn publish_whole(&self) -> io::Result<()> {
        let parent = match self.target.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        fs::create_dir_all(parent)?;
        let staging = within(parent)?;
        for (name, data) in &self.files {
            let file = File::check(&staging.path().join(name), &[]).map_err(io::Error::other)?;
            file.write(data).map_err(io::Error::other)?;
        }
        fs::rename(staging.path(), &self.target)
    }
}

/// A folder that is removed again unless it is renamed.
fn within(folder: &Path) -> io::Result<TempDir> {
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    let mut builder = Builder::new();
    builder.prefix(".out-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o777));
    builder.tempdir_in(folder)
}
