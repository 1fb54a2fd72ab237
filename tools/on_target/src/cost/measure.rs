//! Runs an image and asks its objects.

use super::count::{Counted, parse};
use super::flash::{Linked, Objects, names_at};
use super::images::{Image, PROFILE, Settings, Subject};
use super::row::Row;
use super::study::Study;
use crate::boards::Board;
use crate::failure::{Failure, Result, While};
use crate::qemu::{self, Emulation};
use std::time::Duration;

const EMULATION: Emulation = Emulation {
    counts: true,
    timeout: Duration::from_secs(600),
};

/// A subject's rows on a board, and what its laws take with all of their operations.
pub(crate) struct Measured {
    pub(crate) rows: Vec<Row>,
    /// Board, law, type, bytes.
    pub(crate) whole_laws: Vec<(String, String, String, u64)>,
    pub(crate) image: Image,
    /// The section of each row's function.
    pub(crate) sections: Vec<String>,
}

/// Builds and measures; `only` may name a law and an operation.
pub(crate) fn subject(
    board: &Board,
    subject: &Subject,
    only: &[&str],
    study: &Study,
    rustc: &str,
) -> Result<Measured> {
    built(board, subject, PROFILE, only, study, rustc)
}

/// The same of another build.
pub(crate) fn built(
    board: &Board,
    subject: &Subject,
    settings: Settings,
    only: &[&str],
    study: &Study,
    rustc: &str,
) -> Result<Measured> {
    let image = Image::build(board, subject, settings)?;
    let what = format!("{}: {}", board.name, subject.name);
    let output = qemu::run(board, &image.elf, only, EMULATION)?;
    let counted = parse(&String::from_utf8_lossy(&output)).map_err(|e| of(&what, e))?;
    if counted.is_empty() {
        return Err(of(&what, format!("no operation {}", only.join(" "))));
    }
    let read = |path: &std::path::Path| std::fs::read(path).while_(path.display());
    let elf = read(&image.elf)?;
    let mut objects = Objects::default();
    for object in &image.objects {
        objects.add(&read(object)?).map_err(|e| of(&what, e))?;
    }
    let (mut rows, mut sections) = (Vec::new(), Vec::new());
    let mut functions: Vec<(&Counted, String)> = Vec::new();
    for operation in &counted {
        let what = format!("{what}: {} {}", operation.law, operation.operation);
        let names = names_at(&elf, operation.address).map_err(|e| of(&what, e))?;
        let known = names.iter().find(|name| objects.has(name));
        let name = known.ok_or_else(|| of(&what, "its function is in no object".to_owned()))?;
        let linked = objects.linked(&[name]).map_err(|e| of(&what, e))?;
        sound(subject, &linked).map_err(|e| of(&what, e))?;
        rows.push(Row::new(board, subject, operation, &linked, study, rustc));
        sections.push(objects.section(name).unwrap_or_default().to_owned());
        functions.push((operation, name.clone()));
    }
    let mut whole_laws = Vec::new();
    let mut laws: Vec<&str> = counted.iter().map(|c| c.law.as_str()).collect();
    laws.dedup();
    for law in laws {
        let of_law = functions.iter().filter(|(c, _)| c.law == law);
        let names: Vec<&str> = of_law.map(|(_, name)| name.as_str()).collect();
        let linked = objects.linked(&names).map_err(|e| of(&what, e))?;
        let [board, name] = [board.name, subject.name].map(str::to_owned);
        whole_laws.push((board, law.to_owned(), name, linked.flash));
    }
    Ok(Measured {
        rows,
        whole_laws,
        image,
        sections,
    })
}

fn of(what: &str, e: String) -> Failure {
    Failure(format!("{what}: {e}"))
}

/// What the crate promises of its own code.
fn sound(subject: &Subject, linked: &Linked) -> std::result::Result<(), String> {
    if !linked.undefined.is_empty() {
        return Err(format!("undefined: {:?}", linked.undefined));
    }
    if subject.ours && linked.panics {
        return Err("a panic can be reached".to_owned());
    }
    if subject.ours && linked.ram > 0 {
        return Err(format!("{} bytes of static RAM", linked.ram));
    }
    Ok(())
}
