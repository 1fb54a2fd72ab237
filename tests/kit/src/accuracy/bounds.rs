//! The one table of allowed errors: `docs/bounds.md`, which the rustdoc shows too.

use super::format::Format;
use super::op::OPERATIONS;
#[cfg(test)]
use super::reference::Id;
use super::subject::Subject;
use super::tally::{Stat, Tally};
use crate::promises_ulps;

const TABLE: &str = include_str!("../../../../docs/bounds.md");

/// The cell of an operation of a law, from the section of the number type; `None` for "–".
pub fn allowed(tier: &str, law: &str, operation: &str) -> Option<f64> {
    let rows = section(tier);
    let column = rows
        .first()
        .unwrap_or_else(|| panic!("docs/bounds.md: no section {tier}"))
        .iter()
        .position(|c| c == law)
        .unwrap_or_else(|| panic!("docs/bounds.md: no column {law} under {tier}"));
    let row = rows
        .iter()
        .find(|r| r[0] == operation)
        .unwrap_or_else(|| panic!("docs/bounds.md: no row {operation} under {tier}"));
    row[column].parse().ok()
}

/// Rows of the section `## tier`, the header first, cells trimmed.
fn section(tier: &str) -> Vec<Vec<String>> {
    let title = format!("## {tier}");
    TABLE
        .lines()
        .skip_while(|l| l.replace('`', "") != title)
        .skip(1)
        .take_while(|l| !l.starts_with("## "))
        .filter(|l| l.starts_with('|') && !l.starts_with("|--"))
        .map(|l| {
            l.trim_matches('|')
                .split('|')
                .map(|c| c.trim().to_owned())
                .collect()
        })
        .collect()
}

/// The error in the unit of its section: ulps, or 2⁻¹² of the true value for the types that promise
/// no ulps.
pub fn in_unit(tier: &str, stat: &Stat) -> f64 {
    if promises_ulps(tier) {
        stat.ulps
    } else {
        stat.relative * 4096.0
    }
}

/// Sentences on all that exceeds its cell. A cell of 0.5 promises correct rounding, ties included.
pub fn broken<F: Format>(subjects: &[Subject<F>], tally: &Tally) -> Vec<String> {
    let mut all = Vec::new();
    for (s, row) in subjects.iter().zip(&tally.0) {
        for ((_, name), stat) in OPERATIONS.iter().zip(row) {
            if stat.tried == 0 {
                continue;
            }
            let limit = allowed(s.tier, s.id.name(), name).unwrap_or(0.0);
            let what = format!("{} {:?} {name}", s.tier, s.id);
            let error = in_unit(s.tier, stat);
            if error > limit {
                let (input, of) = (stat.input, stat.of.name());
                all.push(format!(
                    "{what}: {error:.3} at {of} {input:#x}, {limit} allowed"
                ));
            }
            let misrounded = stat.misrounded_count();
            if limit == 0.5 && misrounded > 0 {
                let inputs = &stat.misrounded;
                all.push(format!("{what}: {misrounded} misrounded, {inputs:#x?}"));
            }
        }
    }
    all
}

/// Every operation that the tests measure has a row in the section of every number type that
/// exists, and no other has one.
#[test]
fn the_table_is_complete() {
    use super::subject::Tiers;
    let mut tiers: Vec<_> = f32::tiers(Id::Disk).iter().map(|s| s.tier).collect();
    tiers.extend(f64::tiers(Id::Disk).iter().map(|s| s.tier));
    for tier in tiers {
        let names: Vec<_> = section(tier)[1..].iter().map(|r| r[0].clone()).collect();
        let expected: Vec<_> = OPERATIONS
            .iter()
            .map(|(_, name)| name.to_string())
            .collect();
        assert_eq!(names, expected, "rows under {tier}");
        for law in Id::FIXED.into_iter().chain([Id::CosPower(1.0)]) {
            for (_, name) in OPERATIONS {
                let solid = name == "pdf_solid_angle";
                assert_eq!(
                    allowed(tier, law.name(), name).is_none(),
                    solid && law.planar(),
                    "{tier} {law:?} {name}"
                );
            }
        }
    }
}
