//! The modules of a crate and what each imports.

use std::collections::BTreeMap;
use std::fs::{read_dir, read_to_string};
use std::path::{Path, PathBuf};

pub(crate) struct Source {
    /// `["law", "ball"]` for `src/law/ball.rs`, `["law"]` for `src/law/mod.rs`.
    pub(crate) module: Vec<String>,
    /// Modules that it names, wherever it does.
    pub(crate) imports: Vec<Vec<String>>,
    /// Without comments and unit tests.
    pub(crate) text: String,
}

/// Every Rust file below a folder of the crate, and its text.
pub(crate) fn files(folder: &Path) -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut found = Vec::new();
    let mut open = vec![root.join(folder)];
    while let Some(folder) = open.pop() {
        for entry in read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                if !path.ends_with("target") {
                    open.push(path);
                }
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = read_to_string(&path).unwrap();
                found.push((path.strip_prefix(root).unwrap().to_owned(), text));
            }
        }
    }
    found.sort();
    found
}

/// The code: no comments, nothing from a module of unit tests on.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = text.lines().map(|line| match line.find("//") {
        Some(i) => &line[..i],
        None => line,
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The paths that a `use` tree names: `a::{b, c::D}` is `a::b` and `a::c::D`.
fn paths(tree: &str) -> Vec<String> {
    let tree = tree.trim();
    let Some(open) = tree.find('{') else {
        return vec![tree.split(" as ").next().unwrap().trim().to_owned()];
    };
    let (mut depth, mut start, mut items) = (0, open + 1, Vec::new());
    for (i, c) in tree.char_indices().skip(open) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if (c == ',' && depth == 1) || (c == '}' && depth == 0) {
            items.push(&tree[start..i]);
            start = i + 1;
        }
    }
    let items = items.into_iter().filter(|item| !item.trim().is_empty());
    items
        .flat_map(paths)
        .map(|path| format!("{}{path}", &tree[..open]))
        .collect()
}

/// What the text names: its `use`s but for the ones that hand names on, and paths by `crate::` in
/// the code.
fn named(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = String::new();
    for statement in text.split_inclusive(';') {
        match used(statement) {
            Some((false, tree)) => found.extend(paths(tree)),
            Some((true, _)) => {}
            None => rest += statement,
        }
    }
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    for (i, _) in rest.match_indices("crate::") {
        found.push(rest[i..].chars().take_while(|&c| is_part(c)).collect());
    }
    found
}

/// Whether a `use` hands its names on, and its tree.
fn used(statement: &str) -> Option<(bool, &str)> {
    let line = statement.trim_end_matches(';');
    let start = line
        .rfind("use ")
        .filter(|&i| i == 0 || line[..i].ends_with(['\n', ' ']))?;
    let before = line[..start].rsplit('\n').next().unwrap();
    Some((before.trim_start().starts_with("pub"), &line[start + 4..]))
}

/// Names that a module hands on, and where they are from.
fn faces(text: &str, module: &[String]) -> BTreeMap<String, Vec<String>> {
    let mut handed = BTreeMap::new();
    for statement in text.split_inclusive(';') {
        let Some((true, tree)) = used(statement) else {
            continue;
        };
        for path in paths(tree) {
            let mut parts: Vec<String> = path.split("::").map(str::to_owned).collect();
            let name = parts.last().unwrap().clone();
            match parts[0].as_str() {
                "crate" => drop(parts.remove(0)),
                _ => parts = [module, &parts].concat(),
            }
            handed.insert(name, parts);
        }
    }
    handed
}

/// The modules of the crate whose sources are in `folder`.
pub(crate) fn sources(folder: &str) -> Vec<Source> {
    let mut texts = BTreeMap::new();
    for (path, text) in files(Path::new(folder)) {
        let path = path.strip_prefix(folder).unwrap().with_extension("");
        let mut module: Vec<String> = path
            .iter()
            .map(|p| p.to_string_lossy().into_owned())
            .collect();
        if module
            .last()
            .is_some_and(|m| ["mod", "lib", "main"].contains(&m.as_str()))
        {
            module.pop();
        }
        let test = |m: &String| m == "tests" || m == "hostile";
        if !module.iter().any(test) {
            texts.insert(module, code(&text));
        }
    }
    let handed: BTreeMap<_, _> = texts
        .iter()
        .map(|(m, t)| (m.clone(), faces(t, m)))
        .collect();
    let resolve = |mut path: Vec<String>| {
        for _ in 0..9 {
            let module = (0..=path.len()).rev().map(|n| path[..n].to_vec());
            let module = module.into_iter().find(|m| texts.contains_key(m))?;
            let from = path
                .get(module.len())
                .and_then(|name| handed[&module].get(name));
            match from {
                Some(from) => path = [&from[..], &path[module.len() + 1..]].concat(),
                None => return (!module.is_empty()).then_some(module),
            }
        }
        None
    };
    let sources = texts.iter().filter(|(module, _)| !module.is_empty());
    let sources = sources.map(|(module, text)| {
        let mut imports = Vec::new();
        for path in named(text) {
            let mut parts: Vec<String> = path.split("::").map(str::to_owned).collect();
            let mut base = module.clone();
            match parts[0].as_str() {
                "crate" => base.clear(),
                "super" | "self" => {}
                child if texts.contains_key(&[&module[..], &[child.to_owned()]].concat()) => {}
                _ => continue,
            }
            while parts.first().is_some_and(|p| p == "super") {
                base.pop();
                parts.remove(0);
            }
            if parts.first().is_some_and(|p| p == "crate" || p == "self") {
                parts.remove(0);
            }
            imports.extend(resolve([base, parts].concat()).filter(|i| i != module));
        }
        Source {
            module: module.clone(),
            imports,
            text: text.clone(),
        }
    });
    sources.collect()
}

#[test]
fn trees_of_uses() {
    assert_eq!(
        paths("crate::{CosSin, law::{Ball, Disk as D}, uniform}"),
        [
            "crate::CosSin",
            "crate::law::Ball",
            "crate::law::Disk",
            "crate::uniform"
        ]
    );
    assert_eq!(
        named("pub(crate) use a::B;\nuse super::c::D;"),
        ["super::c::D"]
    );
    assert_eq!(named("fn f() {\n    crate::a::b(1)\n}"), ["crate::a::b"]);
}
