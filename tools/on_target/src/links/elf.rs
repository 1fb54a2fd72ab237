//! What an image holds.

use crate::failure::{Result, While};
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, elf};
use std::fs;
use std::path::Path;

/// A linked image.
pub(super) struct Image {
    data: Vec<u8>,
}

impl Image {
    pub(super) fn read(path: &Path) -> Result<Self> {
        let data = fs::read(path).while_(path.display())?;
        object::File::parse(&*data).while_(path.display())?;
        Ok(Image { data })
    }

    /// The parsed file: [`Image::read`] has tried it.
    pub(super) fn file(&self) -> object::File<'_> {
        object::File::parse(&*self.data).expect("parsed when it was read")
    }

    /// Names of all symbols.
    pub(super) fn symbols(&self) -> Vec<String> {
        let names = self.file();
        let names = names.symbols().filter_map(|s| s.name().ok());
        names.map(str::to_owned).collect()
    }

    /// Bytes of RAM that are its own from start to end: .data, .bss and whatever else can be
    /// written.
    pub(super) fn static_ram(&self) -> u64 {
        let file = self.file();
        let ram = file
            .sections()
            .filter(|s| has(s, elf::SHF_WRITE) && has(s, elf::SHF_ALLOC));
        ram.map(|s| s.size()).sum()
    }

    /// Bytes of flash: code and constants.
    pub(super) fn flash(&self) -> u64 {
        let file = self.file();
        let flash = file
            .sections()
            .filter(|s| has(s, elf::SHF_ALLOC) && !has(s, elf::SHF_WRITE));
        flash.map(|s| s.size()).sum()
    }

    /// Sections of instructions: address and bytes.
    pub(super) fn code(&self) -> Vec<(u64, Vec<u8>)> {
        self.file()
            .sections()
            .filter(|s| has(s, elf::SHF_EXECINSTR))
            .filter_map(|s| Some((s.address(), s.data().ok()?.to_vec())))
            .collect()
    }

    /// Where Thumb code (true) and data among it (false) begin, in order: Arm's mapping symbols.
    pub(super) fn mapping(&self) -> Vec<(u64, bool)> {
        let kind = |name: &str| match name.split('.').next() {
            Some("$t") => Some(true),
            Some("$d") => Some(false),
            _ => None,
        };
        let mut marks: Vec<_> = self
            .file()
            .symbols()
            .filter(|s| s.section_index().is_some())
            .filter_map(|s| Some((s.address(), kind(s.name().ok()?)?)))
            .collect();
        marks.sort_unstable();
        marks
    }
}

fn has(section: &object::Section, flag: elf::SectionFlags) -> bool {
    match section.flags() {
        SectionFlags::Elf { sh_flags, .. } => sh_flags.0 & flag.0 != 0,
        _ => false,
    }
}
