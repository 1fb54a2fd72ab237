//! The rows of the table, and `accuracy_cost.csv` that holds them.

use crate::contender::{Contender, law_name};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::Path;

/// Errors of an operation. Relative errors are `inf` where nothing of the value is left.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Error {
    pub(crate) max_ulp: Option<f64>,
    pub(crate) inputs: Option<u64>,
    pub(crate) exhaustive: Option<bool>,
    pub(crate) worst_input: Option<String>,
    pub(crate) correctly_rounded_percent: Option<f64>,
    pub(crate) misrounded: Option<u64>,
    pub(crate) max_relative: Option<f64>,
    pub(crate) max_relative_tail: Option<f64>,
}

impl Error {
    /// Of a call with two results: the error of the worse one.
    pub(crate) fn worse(self, other: Error) -> Error {
        if other.max_ulp > self.max_ulp {
            other
        } else {
            self
        }
    }
}

/// A line of the CSV; its columns are these fields.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Row {
    pub(crate) law: String,
    pub(crate) operation: String,
    /// A number type of ours or a peer.
    pub(crate) name: String,
    pub(crate) ours: bool,
    pub(crate) format: String,
    pub(crate) max_ulp: Option<f64>,
    pub(crate) inputs: Option<u64>,
    pub(crate) exhaustive: Option<bool>,
    pub(crate) worst_input: Option<String>,
    pub(crate) correctly_rounded_percent: Option<f64>,
    pub(crate) misrounded: Option<u64>,
    pub(crate) max_relative: Option<f64>,
    pub(crate) max_relative_tail: Option<f64>,
    /// Mean instructions of a call.
    pub(crate) instructions: Option<f64>,
    /// Time of a call, as a share of the plain type's of the same format.
    pub(crate) time_to_plain: f64,
    pub(crate) next_u32: Option<f64>,
    pub(crate) next_u64: Option<f64>,
}

/// A row's law, operation and name.
pub(crate) type Key = (String, String, String);

impl Row {
    pub(crate) fn new(c: &Contender, instructions: Option<f64>, time_to_plain: f64) -> Row {
        let words = c.cell.words;
        Row {
            law: law_name(c.law),
            operation: c.operation.to_owned(),
            name: c.name.clone(),
            ours: c.ours,
            format: c.format.to_owned(),
            max_ulp: None,
            inputs: None,
            exhaustive: None,
            worst_input: None,
            correctly_rounded_percent: None,
            misrounded: None,
            max_relative: None,
            max_relative_tail: None,
            instructions,
            time_to_plain,
            next_u32: words.map(|w| w.next_u32),
            next_u64: words.map(|w| w.next_u64),
        }
    }

    pub(crate) fn key(&self) -> Key {
        let name = self.name.clone();
        (self.law.clone(), self.operation.clone(), name)
    }

    pub(crate) fn set(&mut self, e: Error) {
        self.max_ulp = e.max_ulp;
        self.inputs = e.inputs;
        self.exhaustive = e.exhaustive;
        self.worst_input = e.worst_input;
        self.correctly_rounded_percent = e.correctly_rounded_percent;
        self.misrounded = e.misrounded;
        self.max_relative = e.max_relative;
        self.max_relative_tail = e.max_relative_tail;
    }

    fn error(self) -> Error {
        Error {
            max_ulp: self.max_ulp,
            inputs: self.inputs,
            exhaustive: self.exhaustive,
            worst_input: self.worst_input,
            correctly_rounded_percent: self.correctly_rounded_percent,
            misrounded: self.misrounded,
            max_relative: self.max_relative,
            max_relative_tail: self.max_relative_tail,
        }
    }
}

/// The table as CSV.
pub(crate) fn csv(rows: &[Row]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    let bytes = writer.into_inner().map_err(|e| e.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The errors of our operations in an earlier table.
pub(crate) fn read_errors(path: &Path) -> Result<HashMap<Key, Error>, String> {
    let columns = "the columns that a run without --keep-errors writes";
    let explain = |e: csv::Error| match e.position() {
        Some(at) => format!("{}:{}: {e}; expected {columns}", path.display(), at.line()),
        None => format!(
            "{}: {e}; expected a CSV file with {columns}",
            path.display()
        ),
    };
    let mut reader = csv::Reader::from_path(path).map_err(explain)?;
    let mut errors = HashMap::new();
    for row in reader.deserialize() {
        let row: Row = row.map_err(explain)?;
        if row.ours {
            errors.insert(row.key(), row.error());
        }
    }
    Ok(errors)
}
