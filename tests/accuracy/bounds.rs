//! The one table of allowed errors: `docs/bounds.md`, which the rustdoc shows too.

#[cfg(test)]
use super::measure::OPERATIONS;
use super::reference::Id;

const TABLE: &str = include_str!("../../docs/bounds.md");

/// Allowed ulps of an operation of a law, from the section of the format; `None` for "–".
pub fn allowed(format: &str, law: Id, operation: &str) -> Option<f64> {
    let rows = section(format);
    let column = rows[0]
        .iter()
        .position(|c| c == law.name())
        .unwrap_or_else(|| panic!("docs/bounds.md: no column {} under {format}", law.name()));
    let row = rows
        .iter()
        .find(|r| r[0] == operation)
        .unwrap_or_else(|| panic!("docs/bounds.md: no row {operation} under {format}"));
    row[column].parse().ok()
}

/// Rows of the section `## format`, the header first, cells trimmed.
fn section(format: &str) -> Vec<Vec<String>> {
    let title = format!("## {format}");
    TABLE
        .lines()
        .skip_while(|l| *l != title)
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

/// Every operation that the tests measure has a row in both sections, and no other has one.
#[test]
fn the_table_is_complete() {
    for format in ["f32", "f64"] {
        let names: Vec<_> = section(format)[1..].iter().map(|r| r[0].clone()).collect();
        let expected: Vec<_> = OPERATIONS
            .iter()
            .map(|(_, name)| name.to_string())
            .collect();
        assert_eq!(names, expected, "rows under {format}");
        for law in Id::FIXED {
            for (_, name) in OPERATIONS {
                let solid = name == "pdf_solid_angle";
                assert_eq!(
                    allowed(format, law, name).is_none(),
                    solid && law.planar(),
                    "{format} {law:?} {name}"
                );
            }
        }
    }
}
