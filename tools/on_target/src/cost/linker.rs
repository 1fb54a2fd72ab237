//! Asks the linker itself what it keeps of an image's objects for one function.

use super::images::{Image, rustc};
use crate::failure::{Failure, Result, While};
use object::{Object, ObjectSection};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Sections are laid out in another order, with other gaps between them.
const GAPS: u64 = 16;

/// Fails unless the linker keeps `flash` bytes of code and constants for the function in `section`.
pub(crate) fn agrees(image: &Image, section: &str, flash: u64) -> Result<()> {
    let linker = linker()?;
    let folder = image.objects[0].with_extension("linked");
    std::fs::create_dir_all(&folder).while_(format!("creating {}", folder.display()))?;
    let (script, out) = (folder.join("keep.x"), folder.join("kept.elf"));
    let text = format!(
        "SECTIONS {{\n\
         .text : {{ KEEP(*(\"{section}\")) *(.text .text.*) }}\n\
         .rodata : {{ *(.rodata .rodata.* .srodata .srodata.*) }}\n\
         .data : {{ *(.data .data.*) }}\n.bss : {{ *(.bss .bss.*) }}\n\
         /DISCARD/ : {{ *(.init*) *(.ARM.exidx*) *(.ARM.extab*) *(.eh_frame*) }}\n}}\n"
    );
    std::fs::write(&script, text).while_(format!("writing {}", script.display()))?;
    let linked = Command::new(&linker)
        .args(["-flavor", "gnu", "--gc-sections", "-T"])
        .arg(&script)
        .args(&image.objects)
        .arg("-o")
        .arg(&out)
        .output()
        .while_(linker.display())?;
    if !linked.status.success() {
        let errors = String::from_utf8_lossy(&linked.stderr);
        return Err(Failure(format!("{section}: {errors}")));
    }
    let kept = kept(&out)?;
    std::fs::remove_dir_all(&folder).while_(format!("removing {}", folder.display()))?;
    if kept.abs_diff(flash) > GAPS {
        return Err(Failure(format!(
            "{section}: the linker keeps {kept} bytes; expected {flash} ± {GAPS}"
        )));
    }
    Ok(())
}

/// Bytes of code and constants of an image.
fn kept(elf: &Path) -> Result<u64> {
    let what = format!("reading {}", elf.display());
    let bytes = std::fs::read(elf).while_(&what)?;
    let file = object::File::parse(&*bytes).while_(&what)?;
    let sizes = [".text", ".rodata"].map(|n| file.section_by_name(n).map_or(0, |s| s.size()));
    Ok(sizes.iter().sum())
}

/// The linker that comes with the compiler.
fn linker() -> Result<PathBuf> {
    let version = rustc(&["-vV"])?;
    let host = version.lines().find_map(|l| l.strip_prefix("host: "));
    let host = host.ok_or_else(|| Failure("rustc -vV names no host".to_owned()))?;
    let root = rustc(&["--print", "sysroot"])?;
    let linker = Path::new(&root)
        .join("lib/rustlib")
        .join(host)
        .join("bin/rust-lld");
    if linker.exists() {
        Ok(linker)
    } else {
        Err(Failure(format!("no {}", linker.display())))
    }
}
