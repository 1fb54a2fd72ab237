//! The C program of `examples/firmware/c_api` on every board and on this machine, against Rust.

use crate::boards::{BOARDS, Board, succeeds};
use crate::build::{Build, root, workspace};
use crate::c_values;
use crate::difference::same;
use crate::failure::{Failure, Result, While};
use crate::qemu::{self, Emulation};
use crate::report::Report;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// A compiler and what it takes to link for a board.
struct Compiler {
    board: &'static str,
    command: &'static str,
    /// Debian's package.
    package: &'static str,
    flags: &'static [&'static str],
    platform: &'static str,
}

const ARM: Compiler = Compiler {
    board: "M0",
    command: "arm-none-eabi-gcc",
    package: "gcc-arm-none-eabi",
    flags: &["-mthumb", "-mcpu=cortex-m0", FLASH, RAM],
    platform: "platform_arm.c",
};
const FLASH: &str = "-Wl,--defsym=FLASH=0";
const RAM: &str = "-Wl,--defsym=RAM=0x20000000";

const COMPILERS: [Compiler; 4] = [
    ARM,
    Compiler {
        board: "M3",
        flags: &["-mthumb", "-mcpu=cortex-m3", FLASH, RAM],
        ..ARM
    },
    Compiler {
        board: "M4F",
        flags: &[
            "-mthumb",
            "-mcpu=cortex-m4",
            "-mfloat-abi=hard",
            "-mfpu=fpv4-sp-d16",
            FLASH,
            RAM,
        ],
        ..ARM
    },
    Compiler {
        board: "RV32IMC",
        command: "riscv64-unknown-elf-gcc",
        package: "gcc-riscv64-unknown-elf",
        flags: &[
            "-march=rv32imc",
            "-mabi=ilp32",
            "-Wl,--defsym=FLASH=0x80000000",
            "-Wl,--defsym=RAM=0x80400000",
        ],
        platform: "platform_riscv.c",
    },
];

const WARNINGS: [&str; 7] = [
    "-std=c11",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Werror",
    "-Wl,--gc-sections",
];
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

/// The header, the program here, the program on every board.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    header(report);
    if succeeds("cc", &["--version"]) {
        report.outcome("C on this machine", on_host("host", "", &[]));
        let bit = on_host("host", "", &["-DPLANTED_BIT"]);
        report.outcome("C: a planted wrong bit is found", found(bit, "3d026137"));
        let panic = on_host("planted", "--cfg planted", &["-DPLANTED_PANIC"]);
        report.outcome("C: a planted panic is found", found(panic, PANIC));
    } else {
        report.skip("C on this machine: cc is not installed (Debian: apt install gcc)");
    }
    for compiler in &COMPILERS {
        let Some(board) = BOARDS.iter().find(|board| board.name == compiler.board) else {
            return Err(Failure(format!("no board {}", compiler.board)));
        };
        if let Err(reason) = board.has_target().and_then(|()| board.has_emulator()) {
            report.skip(&format!("C on {reason}"));
        } else if !succeeds(compiler.command, &["--version"]) {
            let Compiler {
                command, package, ..
            } = compiler;
            report.skip(&format!(
                "C on {}: {command} is not installed (Debian: apt install {package})",
                board.name
            ));
        } else {
            report.outcome(&format!("{}: C", board.name), on_board(board, compiler));
        }
    }
    Ok(())
}

/// A planted fault has to fail for the reason that names it.
fn found(outcome: Result<()>, reason: &str) -> Result<()> {
    match outcome {
        Err(Failure(text)) if text.contains(reason) => Ok(()),
        Err(other) => Err(other),
        Ok(()) => Err(Failure("it was not seen".into())),
    }
}

fn folder() -> PathBuf {
    workspace().join("c_api")
}

/// The committed header is the one that cbindgen makes.
fn header(report: &mut Report) {
    if !succeeds("cbindgen", &["--version"]) {
        report.skip("C: header: cbindgen is not installed (cargo install cbindgen --locked)");
        return;
    }
    let verify = Command::new("cbindgen")
        .current_dir(folder())
        .args(["--quiet", "--config", "cbindgen.toml"])
        .args(["--verify", "--output", "coslobe.h"])
        .output()
        .while_("starting cbindgen");
    report.outcome(
        "C: the committed header is cbindgen's",
        verify.and_then(|output| {
            if output.status.success() {
                return Ok(());
            }
            Err(Failure(format!(
                "coslobe.h is out of date: cbindgen --config cbindgen.toml --output coslobe.h\n{}",
                String::from_utf8_lossy(&output.stderr)
            )))
        }),
    );
}

/// The program here, from a library built with `rust_flags` in a folder of its own.
fn on_host(name: &str, rust_flags: &str, flags: &[&str]) -> Result<()> {
    let target = root().join("target/on_target").join(name);
    let mut command = Command::new("cargo");
    command
        .current_dir(workspace())
        .args(["build", "--quiet", "--release", "--package", "c_api"])
        .args(["--target", &host_target()?])
        .arg("--target-dir")
        .arg(&target)
        .env_remove("CARGO_MANIFEST_DIR")
        .env("RUSTFLAGS", rust_flags);
    finish(&mut command, "cargo build")?;
    let program = target.join("c_program");
    let mut command = compile("cc", "platform_host.c", &program);
    command
        .args(flags)
        .arg(library(&target.join(host_target()?)));
    finish(&mut command, "cc")?;
    let output = finish(&mut Command::new(&program), "the C program")?;
    judge(&program, &output)
}

fn on_board(board: &Board, compiler: &Compiler) -> Result<()> {
    let built = Build {
        board,
        package: "c_api",
        variables: vec![],
        features: &[],
        debug: false,
    }
    .image()?;
    let release = built.parent().ok_or(Failure("a folder".into()))?;
    let image = release.join("c_program");
    let mut command = compile(compiler.command, compiler.platform, &image);
    command
        .args(FREESTANDING)
        .args(compiler.flags)
        .arg("-T")
        .arg(folder().join("c/board.ld"))
        .arg(release.join(LIBRARY))
        .arg("-lgcc");
    finish(&mut command, compiler.command)?;
    let output = qemu::run(board, &image, &[], EMULATION)?;
    judge(&image, &String::from_utf8_lossy(&output))
}

const PANIC: &str = "a panic is linked";
const LIBRARY: &str = "libcoslobe_c.a";

fn library(target: &Path) -> PathBuf {
    target.join("release").join(LIBRARY)
}

fn compile(compiler: &str, platform: &str, program: &Path) -> Command {
    let mut command = Command::new(compiler);
    command
        .args(WARNINGS)
        .arg("-o")
        .arg(program)
        .arg(folder().join("c/main.c"))
        .arg(folder().join("c").join(platform));
    command
}

/// The program printed what Rust computes, and no panic is linked into it.
fn judge(program: &Path, output: &str) -> Result<()> {
    same(&c_values::expected(), output).map_err(Failure)?;
    let image = std::fs::read(program).while_("reading the program")?;
    // In the symbols of core::panicking, which every panic goes through; the handler itself is inlined.
    let name = b"9panicking";
    if image.windows(name.len()).any(|bytes| bytes == name) {
        return Err(Failure(PANIC.into()));
    }
    Ok(())
}

/// Its standard output, if it succeeded.
fn finish(command: &mut Command, what: &str) -> Result<String> {
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
