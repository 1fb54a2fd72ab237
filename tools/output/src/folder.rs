//! A folder that appears whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Files on their way; dropped before [`Staging::publish`] they leave no trace.
pub struct Staging {
    folder: PathBuf,
    target: PathBuf,
    names: Vec<String>,
}

fn explain(path: &Path, e: &io::Error) -> String {
    format!("--out: cannot write {}: {e}", path.display())
}

/// Checked before the work starts: neither the target nor a folder above it may be a file.
pub fn check(target: &Path) -> Result<(), String> {
    let existing = target.ancestors().find(|path| path.exists());
    match existing {
        Some(path) if !path.is_dir() => Err(format!(
            "--out: {} is a file; expected a folder",
            path.display()
        )),
        _ => Ok(()),
    }
}

impl Staging {
    /// A hidden folder on the target's own file system, so that a rename suffices in the end.
    pub fn new(target: &Path) -> Result<Staging, String> {
        check(target)?;
        let hidden = format!(".atlas-{}", std::process::id());
        let folder = match target.parent() {
            _ if target.is_dir() => target.join(hidden),
            Some(parent) => parent.join(hidden),
            None => PathBuf::from(hidden),
        };
        fs::create_dir_all(&folder).map_err(|e| explain(&folder, &e))?;
        Ok(Staging {
            folder,
            target: target.to_owned(),
            names: Vec::new(),
        })
    }

    pub fn add(&mut self, name: String, text: &str) -> Result<(), String> {
        let path = self.folder.join(&name);
        fs::write(&path, text).map_err(|e| explain(&path, &e))?;
        self.names.push(name);
        Ok(())
    }

    /// Puts the files in place. Other files of the target stay.
    pub fn publish(self) -> Result<(), String> {
        if !self.target.exists() {
            return fs::rename(&self.folder, &self.target).map_err(|e| explain(&self.target, &e));
        }
        // All that can be known is asked before the first file moves.
        let blocked = self.names.iter().map(|name| self.target.join(name));
        if let Some(path) = blocked.into_iter().find(|path| path.is_dir()) {
            return Err(format!(
                "--out: {} is a folder; expected a file or nothing",
                path.display()
            ));
        }
        for name in &self.names {
            let path = self.target.join(name);
            fs::rename(self.folder.join(name), &path).map_err(|e| explain(&path, &e))?;
        }
        Ok(())
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // Already renamed, or a failure is being reported: nothing more to say.
        let _ = fs::remove_dir_all(&self.folder);
    }
}
