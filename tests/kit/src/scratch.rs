//! An example as a command, in a folder of its own.
#![allow(dead_code, unreachable_pub)] // each test needs a part

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// A folder of its own for each test, removed at the end.
pub struct Scratch(pub PathBuf);

impl Scratch {
    pub fn new(name: &str) -> Scratch {
        let path = env::temp_dir().join(format!("coslobe-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Scratch(path)
    }

    pub fn names(&self) -> Vec<String> {
        names(&self.0)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

pub fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// An example's binary (one in each test): `cargo test` builds it beside the folder of the tests, and
/// `cargo test --test NAME` does not, so that it is built here where it is missing.
pub fn binary(example: &str) -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| {
        let test = env::current_exe().unwrap();
        let profile = test.parent().unwrap().parent().unwrap();
        let name = format!("{example}{}", env::consts::EXE_SUFFIX);
        let binary = profile.join("examples").join(name);
        if !binary.exists() {
            let name = profile.file_name().unwrap().to_str().unwrap();
            let status = Command::new(env!("CARGO"))
                .args(["build", "--quiet", "--example", example, "--profile"])
                .arg(if name == "debug" { "dev" } else { name })
                .arg("--target-dir")
                .arg(profile.parent().unwrap())
                .current_dir(env!("CARGO_MANIFEST_DIR"))
                .status();
            assert!(status.unwrap().success());
        }
        binary
    })
}
