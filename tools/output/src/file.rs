//! A file that appears whole or not at all.

use crate::plain;
use std::fs::{self, Metadata, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// Where a file will be written: checked before the work that fills it.
#[derive(Debug)]
pub struct File {
    path: PathBuf,
    way: Way,
}

#[derive(Debug)]
enum Way {
    /// A new file takes the place of none or of an old one, whose mode and owner it keeps.
    Replaced(Option<Metadata>),
    /// Devices and pipes are written to, and what stands in a folder that takes no new file.
    Through,
}

fn wrong(path: &Path, what: impl std::fmt::Display) -> String {
    format!("{}: {what}", plain(path.display()))
}

impl File {
    /// The file at `path`, behind its links. `inputs` are what is read; none of them may be
    /// overwritten.
    ///
    /// # Errors
    /// If it is an input, or cannot be written: a folder, a missing or forbidden folder, a name too
    /// long.
    pub fn check(path: &Path, inputs: &[&Path]) -> Result<File, String> {
        let explain = |e: io::Error| wrong(path, format_args!("cannot be written: {e}"));
        let ends_in_name = path.components().next_back().is_some_and(|last| {
            let (path, last) = (path.as_os_str(), last.as_os_str());
            path.as_encoded_bytes().ends_with(last.as_encoded_bytes())
        });
        if path.file_name().is_none() || !ends_in_name {
            return Err(wrong(path, "a folder; expected a file's name"));
        }
        for input in inputs {
            if is_same(path, input).unwrap_or(false) {
                return Err(wrong(
                    path,
                    "is read as well; expected another file to write",
                ));
            }
        }
        let path = behind_links(path).map_err(explain)?;
        let old = match fs::metadata(&path) {
            Ok(old) if old.is_dir() => return Err(wrong(&path, "a folder; expected a file")),
            Ok(old) => Some(old),
            Err(e) if e.kind() == ErrorKind::NotFound => None,
            Err(e) => return Err(explain(e)),
        };
        // Opening a pipe would wait for its reader.
        let way = match &old {
            Some(old) if !old.is_file() => Way::Through,
            Some(_) => {
                OpenOptions::new()
                    .write(true)
                    .open(&path)
                    .map_err(explain)?;
                match beside(&path) {
                    Ok(_) => Way::Replaced(old),
                    Err(_) => Way::Through,
                }
            }
            None => {
                beside(&path).map_err(explain)?;
                Way::Replaced(None)
            }
        };
        Ok(File { path, way })
    }

    /// Writes it.
    ///
    /// # Errors
    /// If that fails; what was there before stays, but for devices and pipes, and no other file is
    /// left.
    pub fn write(&self, data: &[u8]) -> Result<(), String> {
        outlive_limits();
        let written = match &self.way {
            Way::Replaced(old) => self.replace(data, old.as_ref()),
            Way::Through => self.write_through(data),
        };
        written.map_err(|e| wrong(&self.path, format_args!("cannot be written: {e}")))
    }

    fn replace(&self, data: &[u8], old: Option<&Metadata>) -> io::Result<()> {
        let mut new = beside(&self.path)?;
        new.write_all(data)?;
        if let Some(old) = old {
            if !keeps_owner(old, &new)? {
                return self.write_through(data);
            }
            new.as_file().set_permissions(old.permissions())?;
        }
        new.persist(&self.path)?;
        Ok(())
    }

    fn write_through(&self, data: &[u8]) -> io::Result<()> {
        let mut file = OpenOptions::new()
            .write(true)
            .truncate(true)
            .open(&self.path)?;
        file.write_all(data)?;
        file.flush()
    }
}

/// Whether both are one file by whatever names. Opens neither: a pipe would wait for its other end.
#[cfg(unix)]
fn is_same(a: &Path, b: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    let (a, b) = (fs::metadata(a)?, fs::metadata(b)?);
    Ok((a.dev(), a.ino()) == (b.dev(), b.ino()))
}

#[cfg(not(unix))]
fn is_same(a: &Path, b: &Path) -> io::Result<bool> {
    Ok(fs::canonicalize(a)? == fs::canonicalize(b)?)
}

/// The path with its last component's links followed, though they may lead nowhere yet.
fn behind_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..40 {
        match fs::read_link(&path) {
            // What /proc says of open pipes is no path.
            Ok(_) if fs::metadata(&path).is_ok_and(|m| !m.is_file()) => return Ok(path),
            Ok(target) => path = folder(&path).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("too many links"))
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// A file that is removed again unless it takes the place of `path`, which it can do by a rename.
fn beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    // A short name: one made of the file's own could be too long.
    builder.prefix(".out-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder(path))
}

/// Whether the new file could be given to the old one's owner.
#[cfg(unix)]
fn keeps_owner(old: &Metadata, new: &NamedTempFile) -> io::Result<bool> {
    use std::os::unix::fs::{MetadataExt, fchown};
    let now = new.as_file().metadata()?;
    let is_same = (old.uid(), old.gid()) == (now.uid(), now.gid());
    Ok(is_same || fchown(new.as_file(), Some(old.uid()), Some(old.gid())).is_ok())
}

#[cfg(not(unix))]
fn keeps_owner(_: &Metadata, _: &NamedTempFile) -> io::Result<bool> {
    Ok(true)
}

/// Makes a limit on files' sizes an error, where it would end the program and leave half a file.
fn outlive_limits() {
    #[cfg(unix)]
    {
        use signal_hook::consts::SIGXFSZ;
        static ONCE: std::sync::Once = std::sync::Once::new();
        ONCE.call_once(|| {
            let _ = signal_hook::flag::register(SIGXFSZ, std::sync::Arc::default());
        });
    }
}
