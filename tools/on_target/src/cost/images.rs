//! The images that are counted.

use crate::boards::Board;
use crate::build::{root, workspace};
use crate::failure::{Failure, Result, While};
use std::path::PathBuf;
use std::process::Command;

/// An image: a number type of ours, or a peer.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Subject {
    /// The binary of `examples/firmware/cost`.
    pub(crate) binary: &'static str,
    /// The name in the tables.
    pub(crate) name: &'static str,
    /// A few characters for the plot.
    pub(crate) short: &'static str,
    pub(crate) ours: bool,
    pub(crate) format: &'static str,
}

pub(super) const fn ours(
    binary: &'static str,
    name: &'static str,
    format: &'static str,
) -> Subject {
    Subject {
        binary,
        name,
        short: name,
        ours: true,
        format,
    }
}

const fn peer(
    binary: &'static str,
    name: &'static str,
    short: &'static str,
    format: &'static str,
) -> Subject {
    Subject {
        binary,
        name,
        short,
        ours: false,
        format,
    }
}

/// All of them: a new number type is a line here and a binary.
pub(crate) const SUBJECTS: [Subject; 11] = [
    ours("f32", "f32", "f32"),
    ours("fast_f32", "Fast<f32>", "f32"),
    ours("fixed", "Fixed", "i32"),
    ours("fixed16", "Fixed16", "i16"),
    ours("f64", "f64", "f64"),
    ours("precise_f32", "Precise<f32>", "f32"),
    ours("precise_f64", "Precise<f64>", "f64"),
    peer("libm", "textbook, libm f32", "libm", "f32"),
    peer("micromath", "textbook, micromath f32", "micromath", "f32"),
    peer("idsp", "idsp and integer roots", "idsp", "i32"),
    peer("generator", "rand_pcg", "rand_pcg", "u32"),
];

/// How an image is built, where that is not as the profile says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Settings {
    pub(crate) title: &'static str,
    /// What cargo reads.
    pub(crate) variables: &'static [(&'static str, &'static str)],
}

/// As all tables but that of builds have it.
pub(crate) const PROFILE: Settings = Settings {
    title: "opt-level 3",
    variables: &[],
};

/// What the compiler made of a subject for a board.
pub(crate) struct Image {
    /// What runs.
    pub(crate) elf: PathBuf,
    /// What was linked: the program after link-time optimisation, and the compiler's own routines.
    pub(crate) objects: [PathBuf; 2],
}

impl Image {
    pub(crate) fn build(board: &Board, subject: &Subject, settings: Settings) -> Result<Image> {
        let root = root().join("target/on_target/cost");
        std::fs::create_dir_all(&root).while_(format!("creating {}", root.display()))?;
        let object = root.join(format!("{}-{}.o", board.name, subject.binary));
        // One a board, so that boards can be built side by side.
        let folder = root.join(board.name);
        let built = Command::new("cargo")
            .current_dir(workspace())
            .args(["rustc", "--quiet", "--release", "--package", "cost"])
            .args(["--bin", subject.binary, "--target", board.target])
            .arg("--target-dir")
            .arg(&folder)
            .arg("--")
            .arg(format!("--emit=obj={}", object.display()))
            // Of the cargo that runs this program; they would be read as the user's.
            .env_remove("CARGO_MANIFEST_DIR")
            .env_remove("RUSTFLAGS")
            .envs(settings.variables.iter().copied())
            .output()
            .while_("starting cargo")?;
        if !built.status.success() {
            let errors = String::from_utf8_lossy(&built.stderr);
            return Err(Failure(format!(
                "{}: building {}: {errors}",
                board.name, subject.binary
            )));
        }
        Ok(Image {
            elf: folder
                .join(board.target)
                .join("release")
                .join(subject.binary),
            objects: [object, compiler_builtins(board.target)?],
        })
    }
}

/// Soft floats, divisions, copies: what the compiler calls.
fn compiler_builtins(target: &str) -> Result<PathBuf> {
    let folder = rustc(&["--print", "target-libdir", "--target", target])?;
    let what = format!("looking for libcompiler_builtins in {folder}");
    for entry in std::fs::read_dir(&folder).while_(&what)? {
        let path = entry.while_(&what)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("libcompiler_builtins") && name.ends_with(".rlib") {
            return Ok(path);
        }
    }
    Err(Failure(format!("{what}: not there")))
}

/// The compiler that the figures hold for.
pub(crate) fn compiler() -> Result<String> {
    rustc(&["-V"])
}

pub(crate) fn rustc(arguments: &[&str]) -> Result<String> {
    // In the workspace, where the toolchain is the one that builds the images.
    let out = Command::new("rustc")
        .args(arguments)
        .current_dir(workspace())
        .output()
        .while_("starting rustc")?;
    if out.status.success() {
        Ok(String::from_utf8_lossy(&out.stdout).trim().to_owned())
    } else {
        let errors = String::from_utf8_lossy(&out.stderr);
        Err(Failure(format!("rustc {}: {errors}", arguments.join(" "))))
    }
}
