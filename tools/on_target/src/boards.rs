//! The emulated boards.

use crate::failure::{Failure, Result};
use std::process::{Command, Stdio};

/// A processor, its Rust target and the board that QEMU emulates.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Board {
    pub(crate) name: &'static str,
    pub(crate) target: &'static str,
    pub(crate) machine: &'static str,
    pub(crate) emulator: &'static str,
    /// Debian's package of the emulator.
    pub(crate) package: &'static str,
    pub(crate) options: &'static [&'static str],
    /// Instead of the profile's, where flash is scarce.
    pub(crate) opt_level: Option<&'static str>,
}

const M0: Board = Board {
    name: "M0",
    target: "thumbv6m-none-eabi",
    machine: "microbit",
    emulator: "qemu-system-arm",
    package: "qemu-system-arm",
    // What no device has: images that hold all laws are linked for it (`large-flash`).
    options: &["-global", "nrf51-soc.flash-size=1048576"],
    opt_level: Some("s"),
};

/// All boards, the smallest first.
pub(crate) const BOARDS: [Board; 4] = [
    M0,
    Board {
        name: "M3",
        target: "thumbv7m-none-eabi",
        machine: "mps2-an385",
        options: &[],
        opt_level: None,
        ..M0
    },
    Board {
        name: "M4F",
        target: "thumbv7em-none-eabihf",
        machine: "mps2-an386",
        options: &[],
        opt_level: None,
        ..M0
    },
    Board {
        name: "RV32IMC",
        target: "riscv32imc-unknown-none-elf",
        machine: "virt",
        emulator: "qemu-system-riscv32",
        package: "qemu-system-misc",
        options: &["-bios", "none"],
        opt_level: None,
    },
];

impl Board {
    /// Whether the target's standard library can be had; adds it if need be.
    pub(crate) fn has_target(&self) -> Result<()> {
        if succeeds("rustup", &["target", "add", self.target]) || self.target_is_there() {
            return Ok(());
        }
        Err(Failure(format!(
            "{}: rustup cannot add the target {}",
            self.name, self.target
        )))
    }

    /// Without rustup: whether the compiler can find the target's core.
    fn target_is_there(&self) -> bool {
        let arguments = ["--print", "target-libdir", "--target", self.target];
        let found = Command::new("rustc").args(arguments).output();
        found
            .is_ok_and(|o| std::path::Path::new(String::from_utf8_lossy(&o.stdout).trim()).exists())
    }

    /// Whether images can be run.
    pub(crate) fn has_emulator(&self) -> Result<()> {
        if succeeds(self.emulator, &["--version"]) {
            return Ok(());
        }
        Err(Failure(format!(
            "{}: {} is not installed (Debian: apt install {})",
            self.name, self.emulator, self.package
        )))
    }
}

/// Whether a command exists and exits with 0.
pub(crate) fn succeeds(command: &str, arguments: &[&str]) -> bool {
    Command::new(command)
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|s| s.success())
}
