//! The program and the page's example: made, linked and run.

use super::compilers::Compiler;
use super::expected::{expected, sorted};
use crate::boards::Board;
use crate::build::root;
use crate::difference::same;
use crate::failure::{Failure, Result, While};
use crate::qemu::{self, Emulation};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

pub(super) const WARNINGS: [&str; 5] =
    ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];
const FREESTANDING: [&str; 5] = [
    "-ffreestanding",
    "-nostdlib",
    "-ffunction-sections",
    "-Wl,--defsym=RAM_SIZE=0x4000",
    "-Wl,--no-warn-execstack",
];
const EMULATION: Emulation = Emulation {
    counts: false,
    timeout: Duration::from_secs(60),
};

pub(super) fn folder() -> PathBuf {
    root().join("examples/c_api")
}

/// Makes `goal` as the page says; where library and header are then.
fn make(goal: &str, target: &str, rust_flags: &str, level: Option<&str>) -> Result<PathBuf> {
    let name = if rust_flags.is_empty() {
        "c"
    } else {
        "c_planted"
    };
    let build = root().join("target/on_target").join(name);
    let mut command = Command::new("make");
    command
        .arg("--directory")
        .arg(folder())
        .arg(goal)
        .arg(format!("BUILD={}", build.display()))
        .arg(format!(
            "CARGO_TARGET_DIR={}",
            build.join("cargo").display()
        ))
        .env_remove("CARGO_MANIFEST_DIR")
        .env("RUSTFLAGS", rust_flags);
    if let Some(level) = level {
        command.env("CARGO_PROFILE_EMBEDDED_OPT_LEVEL", level);
    }
    finish(&mut command, "make")?;
    let built = build.join(target);
    std::fs::write(built.join("calls.h"), c_surface::calls()).while_("writing calls.h")?;
    Ok(built)
}

/// The program here, from a library built with `rust_flags`.
pub(super) fn on_host(rust_flags: &str, flags: &[&str]) -> Result<()> {
    let built = make("host", &host_target()?, rust_flags, None)?;
    let program = built.join("c_program");
    let mut command = compile("cc", "platform_host.c", &built, &program);
    command.args(flags).arg(built.join(LIBRARY));
    finish(&mut command, "cc")?;
    let output = finish(&mut Command::new(&program), "the C program")?;
    judge(&program, &output)
}

/// `make install`, and the example of the page with what that installed.
pub(super) fn installed() -> Result<()> {
    let built = make("host", &host_target()?, "", None)?;
    let prefix = built.join("prefix");
    let mut install = Command::new("make");
    install
        .arg("--directory")
        .arg(folder())
        .arg("install")
        .arg(format!("PREFIX={}", prefix.display()))
        .arg(format!("BUILD={}", parent(&built)?.display()))
        .arg(format!(
            "CARGO_TARGET_DIR={}",
            parent(&built)?.join("cargo").display()
        ))
        .env_remove("CARGO_MANIFEST_DIR");
    finish(&mut install, "make install")?;
    let flags = finish(
        Command::new("pkg-config")
            .args(["--cflags", "--libs", "coslobe"])
            .env("PKG_CONFIG_PATH", prefix.join("lib/pkgconfig")),
        "pkg-config (Debian: apt install pkg-config)",
    )?;
    let program = built.join("example");
    let mut command = Command::new("cc");
    command
        .args(WARNINGS)
        .arg(folder().join("example.c"))
        .args(flags.split_whitespace())
        .arg("-o")
        .arg(&program);
    finish(&mut command, "cc")?;
    let lines = finish(&mut Command::new(&program), "the example")?;
    let upward = lines
        .lines()
        .filter(|line| line.split_whitespace().nth(2) > Some("0"));
    match upward.count() {
        4 => Ok(()),
        n => Err(Failure(format!("{n} directions around +z of 4\n{lines}"))),
    }
}

fn parent(path: &Path) -> Result<&Path> {
    path.parent().ok_or(Failure("a folder".into()))
}

pub(super) fn on_board(board: &Board, compiler: &Compiler) -> Result<()> {
    let built = make(compiler.goal, compiler.target, "", board.opt_level)?;
    let image = built.join("c_program");
    let mut command = compile(compiler.command, compiler.platform, &built, &image);
    command
        .args(FREESTANDING)
        .args(compiler.flags)
        .arg("-T")
        .arg(folder().join("test/board.ld"))
        .arg(built.join(LIBRARY))
        .arg("-lgcc");
    finish(&mut command, compiler.command)?;
    let output = qemu::run(board, &image, &[], EMULATION)?;
    judge(&image, &String::from_utf8_lossy(&output))
}

pub(super) const PANIC: &str = "a panic is linked";
const LIBRARY: &str = "lib/libcoslobe.a";

fn compile(compiler: &str, platform: &str, built: &Path, program: &Path) -> Command {
    let mut command = Command::new(compiler);
    command
        .args(WARNINGS)
        .args(["-std=c99", "-O2", "-Wl,--gc-sections,--strip-debug", "-o"])
        .arg(program)
        .arg("-I")
        .arg(built.join("include"))
        .arg("-I")
        .arg(built)
        .arg(folder().join("test/main.c"))
        .arg(folder().join("test").join(platform));
    command
}

/// The program printed what Rust computes, and no panic is linked into it.
fn judge(program: &Path, output: &str) -> Result<()> {
    same(&expected(), &sorted(output)).map_err(Failure)?;
    let image = std::fs::read(program).while_("reading the program")?;
    // In the symbols of core::panicking, which every panic goes through; the handler is inlined.
    let name = b"9panicking";
    if image.windows(name.len()).any(|bytes| bytes == name) {
        return Err(Failure(PANIC.into()));
    }
    Ok(())
}

/// Its standard output, if it succeeded.
pub(super) fn finish(command: &mut Command, what: &str) -> Result<String> {
    let output = command.output().while_(format!("starting {what}"))?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(Failure(format!(
        "{what}: {}\n{}{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    )))
}

/// This machine's target: the firmware workspace has another default.
fn host_target() -> Result<String> {
    let version = finish(Command::new("rustc").arg("-vV"), "rustc")?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    host.map(str::to_owned)
        .ok_or_else(|| Failure("rustc -vV names no host".into()))
}
