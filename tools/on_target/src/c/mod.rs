//! The C program of `examples/c_api` on every processor and on this machine, against Rust.

mod compilers;
mod expected;
mod lines;
mod program;

use crate::boards::{BOARDS, succeeds};
use crate::failure::{Failure, Result};
use crate::report::Report;
use compilers::COMPILERS;
use program::{PANIC, WARNINGS, finish, folder, installed, on_board, on_host};
use std::process::Command;

/// What compiles the header alone; Debian's `g++` for the second.
const DIALECTS: [(&str, &str, &[&str]); 2] = [
    ("cc", "c", &["c90", "c99", "c11", "c17", "c2x"]),
    ("g++", "c++", &["c++98", "c++11", "c++17", "c++20"]),
];

/// The header, the program here, the program on every processor.
pub(crate) fn run(report: &mut Report) -> Result<()> {
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

fn header_alone(compiler: &str, language: &str, standard: &str) -> Result<()> {
    let mut command = Command::new(compiler);
    command
        .args(WARNINGS)
        .arg(format!("-std={standard}"))
        .args(["-fsyntax-only", "-x", language])
        .arg(folder().join("include/coslobe.h"));
    finish(&mut command, compiler).map(drop)
}
