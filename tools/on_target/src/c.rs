//! The C program of `examples/c_api` on every processor and on this machine, against Rust.

use crate::boards::{BOARDS, Board, succeeds};
use crate::build::root;
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
    /// The Makefile's name for it.
    goal: &'static str,
    /// Rust's.
    target: &'static str,
    board: &'static str,
    command: &'static str,
    /// Debian's package.
    package: &'static str,
    flags: &'static [&'static str],
    platform: &'static str,
}

const ARM: Compiler = Compiler {
    goal: "m0",
    target: "thumbv6m-none-eabi",
    board: "M0",
    command: "arm-none-eabi-gcc",
    package: "gcc-arm-none-eabi",
    flags: &["-mthumb", "-mcpu=cortex-m0", FLASH, RAM],
    platform: "platform_arm.c",
};
const FLASH: &str = "-Wl,--defsym=FLASH=0";
const RAM: &str = "-Wl,--defsym=RAM=0x20000000";

const COMPILERS: [Compiler; 5] = [
    ARM,
    Compiler {
        goal: "m3",
        target: "thumbv7m-none-eabi",
        board: "M3",
        flags: &["-mthumb", "-mcpu=cortex-m3", FLASH, RAM],
        ..ARM
    },
    Compiler {
        goal: "m4",
        target: "thumbv7em-none-eabi",
        board: "M4F",
        flags: &["-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=soft", FLASH, RAM],
        ..ARM
    },
    Compiler {
        goal: "m4f",
        target: "thumbv7em-none-eabihf",
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
        goal: "rv32imc",
        target: "riscv32imc-unknown-none-elf",
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

const WARNINGS: [&str; 5] = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];
/// What compiles the header alone; Debian's `g++` for the second.
const DIALECTS: [(&str, &str, &[&str]); 2] = [
    ("cc", "c", &["c90", "c99", "c11", "c17", "c2x"]),
    ("g++", "c++", &["c++98", "c++11", "c++17", "c++20"]),
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

/// The header, the program here, the program on every processor.
pub(crate) fn run(report: &mut Report) -> Result<()> {
    report.outcome("C: header and functions are their table's", generated());
    for (compiler, language, standards) in DIALECTS {
        if !succeeds(compiler, &["--version"]) {
            report.skip(&format!(
                "C: {compiler} is not installed (Debian: apt install g++)"
            ));
            continue;
        }
        for standard in standards {
            let name = format!("C: the header in {standard}");
            report.outcome(&name, header_alone(compiler, language, standard));
        }
    }
    if succeeds("cc", &["--version"]) && succeeds("make", &["--version"]) {
        report.outcome("C on this machine", on_host("", &[]));
        let bit = on_host("", &["-DPLANTED_BIT"]);
        report.outcome("C: a planted wrong bit is found", found(bit, "coslobe_b"));
        let panic = on_host("--cfg planted", &["-DPLANTED_PANIC"]);
        report.outcome("C: a planted panic is found", found(panic, PANIC));
        report.outcome("C: installed, its example by pkg-config", installed());
    } else {
        report
            .skip("C on this machine: cc or make is missing (Debian: apt install build-essential)");
    }
    for compiler in &COMPILERS {
        let Some(board) = BOARDS.iter().find(|board| board.name == compiler.board) else {
            return Err(Failure(format!("no board {}", compiler.board)));
        };
        let (command, package) = (compiler.command, compiler.package);
        if !succeeds(compiler.command, &["--version"]) {
            report.skip(&format!(
                "C for {}: {command} is not installed (Debian: apt install {package})",
                compiler.goal
            ));
        } else if let Err(reason) = board.has_emulator() {
            report.skip(&format!("C on {reason}"));
        } else {
            report.outcome(&format!("{}: C", compiler.goal), on_board(board, compiler));
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
    root().join("examples/c_api")
}

/// The committed files are those that their table makes.
fn generated() -> Result<()> {
    let mut command = Command::new("python3");
    command.arg(root().join("tools/c_api.py")).arg("--check");
    finish(&mut command, "python3 tools/c_api.py").map(drop)
}

fn header_alone(compiler: &str, language: &str, standard: &str) -> Result<()> {
    let mut command = Command::new(compiler);
    command
        .args(WARNINGS)
        .arg(format!("-std={standard}"))
        .args(["-fsyntax-only", "-x", language])
        .arg(folder().join("include/coslobe.h"));
    finish(&mut command, compiler).map(drop)
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
    Ok(build.join(target))
}

/// The program here, from a library built with `rust_flags`.
fn on_host(rust_flags: &str, flags: &[&str]) -> Result<()> {
    let built = make("host", &host_target()?, rust_flags, None)?;
    let program = built.join("c_program");
    let mut command = compile("cc", "platform_host.c", &built, &program);
    command.args(flags).arg(built.join(LIBRARY));
    finish(&mut command, "cc")?;
    let output = finish(&mut Command::new(&program), "the C program")?;
    judge(&program, &output)
}

/// `make install`, and the example of the page with what that installed.
fn installed() -> Result<()> {
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

fn on_board(board: &Board, compiler: &Compiler) -> Result<()> {
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

const PANIC: &str = "a panic is linked";
const LIBRARY: &str = "lib/libcoslobe.a";

fn compile(compiler: &str, platform: &str, built: &Path, program: &Path) -> Command {
    let mut command = Command::new(compiler);
    command
        .args(WARNINGS)
        .args(["-std=c99", "-O2", "-Wl,--gc-sections,--strip-debug", "-o"])
        .arg(program)
        .arg("-I")
        .arg(built.join("include"))
        .arg(folder().join("test/main.c"))
        .arg(folder().join("test").join(platform));
    command
}

/// The program printed what Rust computes, and no panic is linked into it.
fn judge(program: &Path, output: &str) -> Result<()> {
    same(&c_values::expected(), &c_values::sorted(output)).map_err(Failure)?;
    let image = std::fs::read(program).while_("reading the program")?;
    // In the symbols of core::panicking, which every panic goes through; the handler is inlined.
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
