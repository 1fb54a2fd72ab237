//! The house stands as `ARCHITECTURE.md` draws it: no two modules import each other, directly or in
//! a circle, no room imports one above it, files and lines are short, and a law or a number type is
//! named in few files.

mod graph;
mod sources;

use graph::{Graph, circle};
use sources::{Source, files, sources};
use std::collections::BTreeSet;
use std::path::Path;

/// What stands in `src/`, from the ground up. Each imports only what stands before it.
const ROOMS: [&str; 18] = [
    "accuracy",
    "generator",
    "scalar",
    "cos_sin",
    "tails",
    "arithmetic",
    "moments",
    "number",
    "uniform",
    "frame",
    "weight",
    "sample",
    "batch",
    "law",
    "point",
    "integers",
    "self_test",
    "integration",
];

/// The same within `arithmetic/`.
const ARITHMETICS: [&str; 8] = [
    "constants",
    "kernel",
    "logarithmic",
    "holds",
    "native",
    "double",
    "scaled",
    "fast",
];

/// The first two parts of a module's path below `room`: what stands in that folder.
fn within(sources: &[Source], room: &[&str]) -> Graph {
    let depth = room.len();
    let mut graph = Graph::new();
    for source in sources.iter().filter(|s| s.module.starts_with_parts(room)) {
        let Some(from) = source.module.get(depth) else {
            continue; // the folder's own mod.rs
        };
        let stands = graph.entry(from.clone()).or_default();
        let imports = source.imports.iter().filter(|i| i.starts_with_parts(room));
        stands.extend(
            imports
                .filter_map(|i| i.get(depth))
                .filter(|to| *to != from)
                .cloned(),
        );
    }
    graph
}

trait StartsWith {
    fn starts_with_parts(&self, parts: &[&str]) -> bool;
}

impl StartsWith for Vec<String> {
    fn starts_with_parts(&self, parts: &[&str]) -> bool {
        self.len() >= parts.len() && self.iter().zip(parts).all(|(a, b)| a == b)
    }
}

/// The crates in which no file and no folder imports itself by way of others.
const CRATES: [&str; 4] = [
    "src",
    "tools/accuracy_cost/src",
    "tools/on_target/src",
    "examples/atlas/src",
];

#[test]
fn no_circle_of_files() {
    for folder in CRATES {
        let sources = sources(folder).into_iter();
        let graph = sources.map(|s| {
            let imports = s.imports.iter().map(|i| i.join("::"));
            (s.module.join("::"), imports.collect())
        });
        assert_eq!(circle(&graph.collect()), None, "{folder}");
    }
}

/// At every folder, what stands in it is one node, with all that it holds.
#[test]
fn no_circle_of_folders() {
    for crate_ in CRATES {
        let sources = sources(crate_);
        assert!(sources.len() > 10, "{crate_}");
        let mut folders = BTreeSet::from([Vec::new()]);
        for source in &sources {
            folders.extend((1..source.module.len()).map(|n| source.module[..n].to_vec()));
        }
        for folder in folders {
            let parts: Vec<&str> = folder.iter().map(String::as_str).collect();
            let found = circle(&within(&sources, &parts));
            assert_eq!(found, None, "{crate_}: in {parts:?}");
        }
    }
}

#[test]
fn no_room_imports_one_above_it() {
    let sources = sources("src");
    for (room, order) in [(&[][..], &ROOMS[..]), (&["arithmetic"], &ARITHMETICS)] {
        for (from, tos) in within(&sources, room) {
            let place = |name: &str| {
                let place = order.iter().position(|r| *r == name);
                place.unwrap_or_else(|| panic!("{name} has no place in the order of {room:?}"))
            };
            for to in tos {
                assert!(place(&to) < place(&from), "{from} imports {to} in {room:?}");
            }
        }
    }
}

/// Arithmetic knows no law, no generator and no number type of the public interface.
#[test]
fn arithmetic_knows_no_generator() {
    for source in sources("src")
        .iter()
        .filter(|s| s.module[0] == "arithmetic")
    {
        assert!(!source.text.contains("rand_core"), "{:?}", source.module);
    }
}

/// `ARCHITECTURE.md` names every room.
#[test]
fn rooms_are_described() {
    let page = include_str!("../../ARCHITECTURE.md");
    for room in ROOMS.iter().chain(&ARITHMETICS) {
        let found = [format!("`{room}`"), format!("`{room}/`")];
        assert!(found.iter().any(|name| page.contains(name)), "{room}");
    }
}

/// Where Rust is.
const FOLDERS: [&str; 5] = ["src", "tests", "examples", "tools", "fuzz"];

/// What it costs to add a law or a number type: how many Rust files name one.
#[test]
fn a_law_and_a_type_are_named_in_few_files() {
    let texts: Vec<_> = FOLDERS.iter().flat_map(|f| files(Path::new(f))).collect();
    assert!(texts.len() > 300, "{}", texts.len());
    for (name, most) in [("SphereShell", MOST_OF_A_LAW), ("Fast", MOST_OF_A_TYPE)] {
        let naming = texts.iter().filter(|(_, text)| {
            let word = |c: char| c.is_alphanumeric() || c == '_';
            text.split(|c| !word(c)).any(|w| w == name)
        });
        let naming: Vec<_> = naming.map(|(path, _)| path.display()).collect();
        assert!(
            naming.len() <= most,
            "{name}: {}: {naming:#?}",
            naming.len()
        );
    }
}

/// Aims: 55 and 35.
const MOST_OF_A_LAW: usize = 40;
const MOST_OF_A_TYPE: usize = 35;

/// Generated files apart, about 200 lines; under 100 columns the crate and all comments.
#[test]
fn files_and_lines_are_short() {
    for (path, text) in FOLDERS.iter().flat_map(|f| files(Path::new(f))) {
        let ours = path.starts_with("src");
        let first = text.lines().next().unwrap_or_default();
        let generated = ["not by hand", "do not edit", "Made by"]
            .iter()
            .any(|w| first.contains(w));
        let most = match generated {
            true => 1000,
            false => MOST_LINES,
        };
        let lines = text.lines().count();
        assert!(lines <= most, "{}: {lines} lines", path.display());
        for (i, line) in text.lines().enumerate().filter(|_| !generated) {
            let table = line.trim_start().starts_with("//! |");
            if !(ours || line.trim_start().starts_with("//")) {
                continue;
            }
            let (at, columns) = (path.display(), line.chars().count());
            assert!(
                table || columns <= MOST_COLUMNS,
                "{at}:{}: {columns} columns",
                i + 1
            );
        }
    }
}

const MOST_LINES: usize = 265;
const MOST_COLUMNS: usize = 100;
