//! What an operation links: the sections that can be reached from its function, as a linker
//! collects them with `--gc-sections`.

use object::{
    Architecture, Object, ObjectSection, ObjectSymbol, RelocationTarget, SectionKind, SymbolKind,
};
use std::collections::{BTreeSet, HashMap};

/// A section of an object.
type Place = (usize, usize);

/// A section with what it refers to.
struct Section {
    name: String,
    kind: SectionKind,
    size: u64,
    align: u64,
    targets: Vec<Target>,
}

enum Target {
    Here(usize),
    /// Defined in whichever object has it.
    Named(String),
}

/// The sections of some objects.
#[derive(Default)]
pub(crate) struct Objects {
    sections: HashMap<Place, Section>,
    /// Symbols that other objects see.
    global: HashMap<String, Place>,
    /// All functions.
    functions: HashMap<String, Place>,
    objects: usize,
}

/// What is linked for some functions.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Linked {
    /// Code and constants.
    pub(crate) flash: u64,
    /// Initialised and zeroed static memory.
    pub(crate) ram: u64,
    /// Names that no object defines.
    pub(crate) undefined: BTreeSet<String>,
    /// Whether a panic can be reached.
    pub(crate) panics: bool,
}

impl Objects {
    /// Adds a relocatable file or an archive of such.
    pub(crate) fn add(&mut self, bytes: &[u8]) -> Result<(), String> {
        if let Ok(archive) = object::read::archive::ArchiveFile::parse(bytes) {
            for member in archive.members() {
                let member = member.map_err(|e| e.to_string())?;
                let data = member.data(bytes).map_err(|e| e.to_string())?;
                // Archives of the compiler have metadata among their objects.
                if let Ok(file) = object::File::parse(data) {
                    self.object(&file);
                }
            }
            return Ok(());
        }
        let file = object::File::parse(bytes).map_err(|e| e.to_string())?;
        self.object(&file);
        Ok(())
    }

    fn object(&mut self, file: &object::File) {
        if file.architecture() == Architecture::Unknown {
            return;
        }
        let here = self.objects;
        self.objects += 1;
        for symbol in file.symbols() {
            let (Ok(name), Some(section)) = (symbol.name(), symbol.section_index()) else {
                continue;
            };
            let section = section.0;
            if symbol.kind() == SymbolKind::Text {
                self.functions
                    .entry(name.to_owned())
                    .or_insert((here, section));
            }
            if symbol.is_global() {
                self.global
                    .entry(name.to_owned())
                    .or_insert((here, section));
            }
        }
        for section in file.sections() {
            let targets = section.relocations().filter_map(|(_, relocation)| {
                let RelocationTarget::Symbol(index) = relocation.target() else {
                    return None;
                };
                let symbol = file.symbol_by_index(index).ok()?;
                match symbol.section_index() {
                    Some(section) => Some(Target::Here(section.0)),
                    None => Some(Target::Named(symbol.name().ok()?.to_owned())),
                }
            });
            let targets = targets.collect();
            self.sections.insert(
                (here, section.index().0),
                Section {
                    name: section.name().unwrap_or_default().to_owned(),
                    kind: section.kind(),
                    size: section.size(),
                    align: section.align().max(1),
                    targets,
                },
            );
        }
    }

    pub(crate) fn has(&self, function: &str) -> bool {
        self.functions.contains_key(function)
    }

    /// The section that a function is in, which by the compiler's default it has to itself.
    pub(crate) fn section(&self, function: &str) -> Option<&str> {
        let place = self.functions.get(function)?;
        Some(&self.sections.get(place)?.name)
    }

    /// What is linked for functions of these names together.
    pub(crate) fn linked(&self, functions: &[&str]) -> Result<Linked, String> {
        let mut linked = Linked::default();
        let mut reached: BTreeSet<Place> = BTreeSet::new();
        let mut open = Vec::new();
        for name in functions {
            let place = self.functions.get(*name);
            open.push(*place.ok_or_else(|| format!("no function {name} in the objects"))?);
        }
        while let Some(place) = open.pop() {
            if !reached.insert(place) {
                continue;
            }
            for target in &self.sections[&place].targets {
                match target {
                    Target::Here(section) => open.push((place.0, *section)),
                    Target::Named(name) if name.is_empty() => {}
                    Target::Named(name) => {
                        linked.panics |= panics(name);
                        match self.global.get(name) {
                            Some(place) => open.push(*place),
                            None => {
                                linked.undefined.insert(name.clone());
                            }
                        }
                    }
                }
            }
        }
        let own = self.functions.iter().filter(|(_, at)| reached.contains(at));
        linked.panics |= own.into_iter().any(|(name, _)| panics(name));
        let (mut text, mut constants) = (0u64, 0u64);
        for place in &reached {
            let section = &self.sections[place];
            match section.kind {
                SectionKind::Text => text = text.next_multiple_of(section.align) + section.size,
                SectionKind::ReadOnlyData | SectionKind::ReadOnlyString => {
                    constants = constants.next_multiple_of(section.align) + section.size;
                }
                SectionKind::Data | SectionKind::UninitializedData => linked.ram += section.size,
                _ => {}
            }
        }
        linked.flash = text + constants;
        Ok(linked)
    }
}

/// Whether a symbol is of the machinery of panics.
fn panics(name: &str) -> bool {
    name.contains("4core9panicking") || name.contains("rust_begin_unwind")
}

/// Names of the function at an address of a linked image.
pub(crate) fn names_at(elf: &[u8], address: u64) -> Result<Vec<String>, String> {
    let file = object::File::parse(elf).map_err(|e| e.to_string())?;
    let names = file.symbols().filter(|s| {
        // Arm marks Thumb code by an odd address.
        s.kind() == SymbolKind::Text && s.address() & !1 == address
    });
    Ok(names
        .filter_map(|s| s.name().ok().map(str::to_owned))
        .collect())
}

#[cfg(test)]
mod tests;
