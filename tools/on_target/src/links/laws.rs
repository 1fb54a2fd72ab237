//! Images of one law's sampler: the code of what it does not use is absent.

use super::image::build;
use super::sources::bytes_by_file;
use super::{Shown, caught, ensure};
use crate::boards::Board;
use crate::failure::Result;
use crate::types::{FIXED, FIXED16, TYPES, laws};
use indicatif::ProgressBar;
use kit::Id;

/// The types to look at: all where there is an FPU, elsewhere those that firmware takes first.
fn types(board: &Board) -> &'static [&'static str] {
    if board.name == "M4F" {
        &TYPES
    } else {
        &["f32", FIXED, FIXED16]
    }
}

/// Images that [`show`] builds.
pub(super) fn images(board: &Board) -> u64 {
    let images = types(board).iter().map(|number| laws(number).len());
    images.sum::<usize>() as u64 + 1
}

pub(super) fn show(board: &Board, bar: &ProgressBar) -> Shown {
    let mut shown = Vec::new();
    for number in types(board) {
        let outcome = laws(number).iter().try_for_each(|law| {
            let outcome = look(board, law, number, None);
            bar.inc(1);
            outcome
        });
        let what = format!("{number}: a sampler holds no code of other laws or their kernels");
        shown.push((what, outcome));
    }
    let planted = look(board, "Lambert", "f32", Some("plant-law"));
    bar.inc(1);
    shown.push((
        "plant-law is caught".to_owned(),
        caught(planted, "law/disk.rs"),
    ));
    shown
}

fn look(board: &Board, law: &str, number: &str, planted: Option<&str>) -> Result<()> {
    let (path, image) = build(board, &calls(law, number), planted)?;
    let files = bytes_by_file(&path, &image)?;
    // Both formats of fixed point share their laws.
    let folder = if in_integers(number) {
        "integers"
    } else {
        "law"
    };
    let own = format!("{folder}/{}.rs", file(law));
    ensure(files.contains_key(&own), || {
        format!("{law} in {number}: no code of {own}")
    })?;
    let foreign: Vec<_> = files
        .iter()
        .filter(|(name, _)| **name != own && !may_hold(law, name))
        .map(|(name, bytes)| format!("{bytes} bytes from {name}"))
        .collect();
    ensure(foreign.is_empty(), || {
        format!("{law} in {number}: {}", foreign.join(", "))
    })?;
    let (mut needed, has) = (needs(law, number).iter(), |stem: &str| {
        files.keys().any(|f| is(f, stem))
    });
    ensure(
        needs(law, number).is_empty() || needed.any(|stem| has(stem)),
        || {
            format!(
                "{law} in {number}: no code from any of {:?}, so others' absence says nothing",
                needs(law, number)
            )
        },
    )
}

fn in_integers(number: &str) -> bool {
    [FIXED, FIXED16].contains(&number)
}

/// What the image calls: see `examples/firmware/links/src/operations.rs`.
fn calls(law: &str, number: &str) -> String {
    match law {
        "CosPower" if number == FIXED => "fixed_power_sampler(x, rng)".to_owned(),
        _ if number == FIXED => format!("fixed_sampler({law}, rng)"),
        _ if number == FIXED16 => format!("fixed16_sampler({law}, rng)"),
        "Disk" | "CircleShell" | "CircleArc" => format!("planar_sampler::<{number}>({law}, rng)"),
        "CosPower" => format!("power_sampler::<{number}>(x, rng)"),
        _ => format!("spatial_sampler::<{number}>({law}, rng)"),
    }
}

/// `SphereShell` is in `sphere_shell.rs`.
fn file(law: &str) -> String {
    let mut name = String::new();
    for c in law.chars() {
        if c.is_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.extend(c.to_lowercase());
    }
    name
}

/// Kernels that only some samplers use, in any folder of kernels, and those laws.
const KERNELS: [(&str, &[&str]); 11] = [
    ("kepler", &["Disk"]),
    ("disk", &["Disk"]),
    ("cbrt", &["Disk", "SphereShell"]),
    ("power", &["CosPower"]),
    ("log_exp", &["CosPower"]),
    ("log", &["CosPower"]),
    ("log2", &["CosPower"]),
    ("exp2", &["CosPower"]),
    ("tail_root", &["CosPower"]),
    ("atan", &[]),
    ("moment", &[]),
];

/// One of these is in the sampler of the law.
fn needs(law: &str, number: &str) -> &'static [&'static str] {
    match law {
        // In floats it is made of two uniforms.
        "Disk" if in_integers(number) => &["kepler"],
        "CosPower" => &["power", "log_exp", "log", "tail_root"],
        _ => &[],
    }
}

/// Whether a file below `src/` is a kernel of that name.
fn is(file: &str, stem: &str) -> bool {
    (file.starts_with("arithmetic/") || file.starts_with("integers/q"))
        && file.ends_with(&format!("/{stem}.rs"))
}

/// Whether a sampler of the law may hold code of a file that is not the law's own.
fn may_hold(law: &str, file: &str) -> bool {
    let other_law = Id::ALL.iter().any(|law| {
        let name = self::file(law.name());
        file == format!("law/{name}.rs") || file == format!("integers/{name}.rs")
    });
    let stage = file.strip_prefix("integers/").unwrap_or(file);
    let other_stage = ["frame.rs", "point.rs", "weight.rs", "moments.rs"].contains(&stage);
    let other_kernel = KERNELS
        .iter()
        .any(|(stem, laws)| is(file, stem) && !laws.contains(&law));
    !(other_law || other_stage || other_kernel)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_belongs_to_whom() {
        assert_eq!(file("SphereShell"), "sphere_shell");
        assert!(may_hold("Disk", "arithmetic/fast/kepler.rs"));
        assert!(may_hold("Lambert", "arithmetic/fast/root.rs"));
        assert!(may_hold("Lambert", "law/mod.rs"));
        for file in [
            "arithmetic/native/kepler.rs",
            "arithmetic/double/disk.rs",
            "arithmetic/native/atan.rs",
            "arithmetic/native/cbrt.rs",
            "arithmetic/fast/power.rs",
            "integers/q31/log.rs",
            "integers/cos_power.rs",
            "integers/weight.rs",
            "law/disk.rs",
            "point.rs",
        ] {
            assert!(!may_hold("Lambert", file), "{file}");
        }
    }
}
