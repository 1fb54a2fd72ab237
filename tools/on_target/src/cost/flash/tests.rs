//! Hand-made objects, and violations planted in them.

use super::*;
use object::write::{Object as Writer, Relocation, Symbol, SymbolId, SymbolSection};
use object::{BinaryFormat, Endianness, RelocationFlags, SymbolFlags, SymbolScope, elf};

fn symbol(writer: &mut Writer, name: &str, kind: SectionKind, size: u64) -> SymbolId {
    let segment = Vec::new();
    let section = writer.add_section(segment, format!(".{name}").into_bytes(), kind);
    let symbol_kind = match kind {
        SectionKind::Text => SymbolKind::Text,
        _ => SymbolKind::Data,
    };
    let id = writer.add_symbol(Symbol {
        name: name.as_bytes().to_vec(),
        value: 0,
        size,
        kind: symbol_kind,
        scope: SymbolScope::Linkage,
        weak: false,
        section: SymbolSection::Section(section),
        flags: SymbolFlags::None,
    });
    if kind == SectionKind::UninitializedData {
        writer.add_symbol_bss(id, section, size, 4);
    } else {
        writer.add_symbol_data(id, section, &vec![0; size as usize], 4);
    }
    id
}

fn refers(writer: &mut Writer, from: SymbolId, to: SymbolId) {
    let section = writer.symbol(from).section.id().unwrap();
    let flags = RelocationFlags::Elf {
        r_type: elf::R_ARM_ABS32,
    };
    let relocation = Relocation {
        offset: 0,
        symbol: to,
        addend: 0,
        flags,
    };
    writer.add_relocation(section, relocation).unwrap();
}

/// `first` calls `second`, which reads `table`; `alone` calls nothing; `soft` is another object's.
fn objects(planted: impl FnOnce(&mut Writer, SymbolId)) -> Objects {
    let new = || Writer::new(BinaryFormat::Elf, Architecture::Arm, Endianness::Little);
    let (mut program, mut routines) = (new(), new());
    let first = symbol(&mut program, "first", SectionKind::Text, 100);
    let second = symbol(&mut program, "second", SectionKind::Text, 20);
    let table = symbol(&mut program, "table", SectionKind::ReadOnlyData, 8);
    symbol(&mut program, "alone", SectionKind::Text, 4);
    refers(&mut program, first, second);
    refers(&mut program, second, table);
    let soft = program.add_symbol(Symbol {
        name: b"soft".to_vec(),
        value: 0,
        size: 0,
        kind: SymbolKind::Text,
        scope: SymbolScope::Linkage,
        weak: false,
        section: SymbolSection::Undefined,
        flags: SymbolFlags::None,
    });
    refers(&mut program, second, soft);
    symbol(&mut routines, "soft", SectionKind::Text, 40);
    planted(&mut program, second);
    let mut objects = Objects::default();
    objects.add(&program.write().unwrap()).unwrap();
    objects.add(&routines.write().unwrap()).unwrap();
    objects
}

#[test]
fn what_is_reached_is_counted_once() {
    let objects = objects(|_, _| {});
    let linked = objects.linked(&["first"]).unwrap();
    assert_eq!(linked.flash, 100 + 20 + 8 + 40);
    assert_eq!((linked.ram, linked.panics), (0, false));
    assert_eq!(objects.linked(&["first", "second"]).unwrap(), linked);
    assert_eq!(objects.linked(&["alone"]).unwrap().flash, 4);
    assert!(objects.linked(&["gone"]).unwrap_err().contains("gone"));
}

/// Static RAM, a panic and a name that nothing defines, each two calls down.
#[test]
fn planted_violations_are_seen() {
    let found = |name: &'static str, kind| {
        let objects = objects(|program, second| {
            let id = symbol(program, name, kind, 12);
            refers(program, second, id);
        });
        objects.linked(&["first"]).unwrap()
    };
    assert_eq!(found("counter", SectionKind::UninitializedData).ram, 12);
    assert_eq!(found("counter", SectionKind::Data).ram, 12);
    let panics = found("_ZN4core9panicking5panic17h0E", SectionKind::Text);
    assert!(panics.panics);
    let undefined = objects(|program, second| {
        let id = program.add_symbol(Symbol {
            name: b"nowhere".to_vec(),
            value: 0,
            size: 0,
            kind: SymbolKind::Text,
            scope: SymbolScope::Linkage,
            weak: false,
            section: SymbolSection::Undefined,
            flags: SymbolFlags::None,
        });
        refers(program, second, id);
    });
    let undefined = undefined.linked(&["first"]).unwrap().undefined;
    assert_eq!(undefined.into_iter().collect::<Vec<_>>(), ["nowhere"]);
}
