//! The compilers of the processors, by the names that the Makefile has for them.

/// A compiler and what it takes to link for a board.
pub(super) struct Compiler {
    /// The Makefile's name for it.
    pub(super) goal: &'static str,
    /// Rust's.
    pub(super) target: &'static str,
    pub(super) board: &'static str,
    pub(super) command: &'static str,
    /// Debian's package.
    pub(super) package: &'static str,
    pub(super) flags: &'static [&'static str],
    pub(super) platform: &'static str,
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

pub(super) const COMPILERS: [Compiler; 5] = [
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
