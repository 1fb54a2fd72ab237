//! Which source files an image's code comes from, functions that were inlined included.

use super::elf::Image;
use crate::failure::{Failure, Result, While};
use addr2line::Loader;
use std::collections::BTreeMap;
use std::path::Path;

/// Bytes of code by the library's file, its path below `src/`. A byte counts for the file of every function
/// that is inlined there, one around the other.
pub(super) fn bytes_by_file(path: &Path, image: &Image) -> Result<BTreeMap<String, u64>> {
    let loader = Loader::new(path).while_(path.display())?;
    let mut files = BTreeMap::new();
    for (start, bytes) in image.code() {
        // No instruction is shorter than two bytes.
        for address in (start..start + bytes.len() as u64).step_by(2) {
            let mut here: Vec<String> = Vec::new();
            let mut frames = loader.find_frames(address).while_("line tables")?;
            while let Some(frame) = frames.next().while_("line tables")? {
                let file = frame.location.and_then(|l| l.file).and_then(below_src);
                here.extend(file.filter(|f| !here.contains(f)));
            }
            for file in here {
                *files.entry(file).or_default() += 2;
            }
        }
    }
    if files.is_empty() {
        return Err(Failure(format!(
            "{}: no code of the library by the line tables",
            path.display()
        )));
    }
    Ok(files)
}

/// The path below the library's `src/`; None for files of others.
fn below_src(file: &str) -> Option<String> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/src/");
    file.strip_prefix(root).map(str::to_owned)
}
