//! Chooses the board by the target, and writes its linker script.

use std::path::PathBuf;
use std::{env, fs};

/// (target, board, memory, what the linker reads after it)
const BOARDS: [(&str, &str, &str, &str); 4] = [
    (
        "thumbv6m-none-eabi",
        "microbit",
        "FLASH : ORIGIN = 0x00000000, LENGTH = 256K
         RAM   : ORIGIN = 0x20000000, LENGTH = 16K",
        CORTEX_M,
    ),
    ("thumbv7m-none-eabi", "mps2-an385", MPS2, CORTEX_M),
    ("thumbv7em-none-eabihf", "mps2-an386", MPS2, CORTEX_M),
    (
        "riscv32imc-unknown-none-elf",
        "virt",
        "FLASH : ORIGIN = 0x80000000, LENGTH = 4M
         RAM   : ORIGIN = 0x80400000, LENGTH = 4M",
        "REGION_ALIAS(\"REGION_TEXT\", FLASH);
         REGION_ALIAS(\"REGION_RODATA\", FLASH);
         REGION_ALIAS(\"REGION_DATA\", RAM);
         REGION_ALIAS(\"REGION_BSS\", RAM);
         REGION_ALIAS(\"REGION_HEAP\", RAM);
         REGION_ALIAS(\"REGION_STACK\", RAM);",
    ),
];

const MPS2: &str = "FLASH : ORIGIN = 0x00000000, LENGTH = 4M
         RAM   : ORIGIN = 0x20000000, LENGTH = 4M";

/// `cortex-m-rt` finds `memory.x` by itself.
const CORTEX_M: &str = "";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = env::var("TARGET").expect("cargo sets TARGET");
    let Some((_, board, memory, regions)) = BOARDS.iter().find(|b| b.0 == target) else {
        let known = BOARDS.map(|b| b.0).join(", ");
        println!("cargo::error=no board for {target}; expected one of {known}");
        return;
    };
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    let write = |name: &str, text: String| {
        fs::write(out.join(name), text).expect("OUT_DIR is writable");
    };
    // What no device has: the images that count costs hold every operation, and QEMU gives them the
    // room.
    let memory = if env::var_os("CARGO_FEATURE_LARGE_FLASH").is_some() {
        memory.replace("256K", "1M")
    } else {
        memory.to_string()
    };
    write("memory.x", format!("MEMORY\n{{\n{memory}\n}}\n{regions}\n"));
    let link = if regions.is_empty() {
        "INCLUDE link.x\n"
    } else {
        "INCLUDE memory.x\nINCLUDE link.x\n"
    };
    write("board.x", link.to_owned());
    println!("cargo::rustc-link-search={}", out.display());
    println!("cargo::rustc-cfg=board=\"{board}\"");
}
