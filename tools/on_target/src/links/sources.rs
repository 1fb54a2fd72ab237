//! Which source files an image's code comes from, functions that were inlined included.

use super::elf::Image;
use crate::build::root;
use crate::failure::{Failure, Result, While};
use addr2line::Loader;
use std::collections::BTreeMap;
use std::path::Path;

/// Bytes of code by the library's file, its path below `src/`. A byte counts for the file of every
/// function that is inlined there, one around the other.
pub(super) fn bytes_by_file(path: &Path, image: &Image) -> Result<BTreeMap<String, u64>> {
    let root = root().join("src/");
    let root = root.to_string_lossy();
    bytes_by(path, image, |file, _| {
        file.strip_prefix(&*root).map(str::to_owned)
    })
}

/// Bytes of code by the functions of the files below `folder`, a folder of this repository;
/// `file::function`.
pub(super) fn bytes_by_function(
    path: &Path,
    image: &Image,
    folder: &str,
) -> Result<BTreeMap<String, u64>> {
    let root = format!("{}/{folder}/", root().display());
    bytes_by(path, image, |file, function| {
        let file = file.strip_prefix(&root)?;
        Some(format!("{file}::{}", last_part(function)))
    })
}

/// Bytes of code by what `name` makes of a frame's file and its function's name.
fn bytes_by(
    path: &Path,
    image: &Image,
    name: impl Fn(&str, &str) -> Option<String>,
) -> Result<BTreeMap<String, u64>> {
    let loader = Loader::new(path).while_(path.display())?;
    let mut names = BTreeMap::new();
    for (start, bytes) in image.code() {
        // No instruction is shorter than two bytes.
        for address in (start..start + bytes.len() as u64).step_by(2) {
            let mut here: Vec<String> = Vec::new();
            let mut frames = loader.find_frames(address).while_("line tables")?;
            while let Some(frame) = frames.next().while_("line tables")? {
                let function = frame.function.as_ref().map(|f| f.raw_name());
                let function = function.and_then(|f| f.ok()).unwrap_or_default();
                let file = frame.location.and_then(|l| l.file);
                let name = file.and_then(|file| name(file, &function));
                here.extend(name.filter(|n| !here.contains(n)));
            }
            for name in here {
                *names.entry(name).or_default() += 2;
            }
        }
    }
    if names.is_empty() {
        return Err(Failure(format!(
            "{}: no code of the library by the line tables",
            path.display()
        )));
    }
    Ok(names)
}

/// The function itself: `scattered` of `_ZN…9scattered17h0123456789abcdefE` and of `scattered<[f32;
/// 3], ()>`, as functions that are inlined everywhere are called.
fn last_part(name: &str) -> &str {
    let Some(mangled) = name.strip_prefix("_ZN") else {
        return name.split('<').next().unwrap_or(name);
    };
    let path = mangled.len().checked_sub("17h0123456789abcdefE".len());
    let path = path.and_then(|end| mangled.get(..end)).unwrap_or(mangled);
    let start = path
        .rfind(|c: char| c.is_ascii_digit())
        .map_or(0, |i| i + 1);
    &path[start..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_function_is_told_from_its_path() {
        let scattered = "_ZN10shade_core6effect4lamp9scattered17h0123456789abcdefE";
        assert_eq!(last_part(scattered), "scattered");
        assert_eq!(last_part("scattered<[f32; 3], f32>"), "scattered");
        assert_eq!(last_part("main"), "main");
    }
}
