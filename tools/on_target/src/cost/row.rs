//! The rows of `docs/measured/firmware_cost.csv`.

use super::count::Counted;
use super::flash::Linked;
use super::images::Subject;
use super::study::Study;
use super::{integers, peers};
use crate::boards::Board;
use crate::failure::{Failure, Result, While};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A line: what an operation costs on a board, beside its errors. The columns are these fields.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Row {
    pub(crate) board: String,
    pub(crate) target: String,
    pub(crate) law: String,
    pub(crate) operation: String,
    /// A number type of ours or a peer.
    pub(crate) name: String,
    pub(crate) ours: bool,
    pub(crate) format: String,
    pub(crate) instructions_least: u64,
    pub(crate) instructions_mean: f64,
    pub(crate) instructions_most: u64,
    pub(crate) flash_bytes: u64,
    pub(crate) stack_bytes: u64,
    pub(crate) ram_bytes: u64,
    /// Words of 32 bits that it draws.
    pub(crate) words: u64,
    pub(crate) max_ulp: Option<f64>,
    pub(crate) max_relative: Option<f64>,
    /// Of directions in integers, whose unit is absolute.
    pub(crate) max_absolute: Option<f64>,
    /// The compiler, without which no figure holds.
    pub(crate) rustc: String,
}

impl Row {
    pub(crate) fn new(
        board: &Board,
        subject: &Subject,
        counted: &Counted,
        linked: &Linked,
        study: &Study,
        rustc: &str,
    ) -> Row {
        let (law, operation) = (counted.law.as_str(), counted.operation.as_str());
        // Whichever generator draws, the direction is the same function of its words.
        let known_as = match operation {
            "sample_xorshift" => "sample",
            _ => operation,
        };
        let known = study.find(law, known_as, subject.name);
        let max_relative = if subject.ours {
            known.max_relative
        } else {
            peers::error(subject.binary, law, known_as)
        };
        Row {
            board: board.name.to_owned(),
            target: board.target.to_owned(),
            law: law.to_owned(),
            operation: operation.to_owned(),
            name: subject.name.to_owned(),
            ours: subject.ours,
            format: subject.format.to_owned(),
            instructions_least: counted.least(),
            instructions_mean: (counted.mean() * 100.0).round() / 100.0,
            instructions_most: counted.most(),
            flash_bytes: linked.flash,
            stack_bytes: counted.stack,
            ram_bytes: linked.ram,
            words: counted.words,
            max_ulp: known.max_ulp,
            max_relative,
            max_absolute: integers::error(subject.binary, law, known_as),
            rustc: rustc.to_owned(),
        }
    }

    pub(crate) fn key(&self) -> [&str; 4] {
        [&self.board, &self.law, &self.operation, &self.name]
    }

    /// What has to repeat itself with the same compiler.
    pub(crate) fn measured(&self) -> [f64; 7] {
        [
            self.instructions_least as f64,
            self.instructions_mean,
            self.instructions_most as f64,
            self.flash_bytes as f64,
            self.stack_bytes as f64,
            self.ram_bytes as f64,
            self.words as f64,
        ]
    }
}

/// The table as CSV.
pub(crate) fn csv(rows: &[Row]) -> std::result::Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    let bytes = writer.into_inner().map_err(|e| e.into_error())?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The committed table.
pub(crate) fn read(path: &Path) -> Result<Vec<Row>> {
    let what = || format!("reading {}", path.display());
    let mut reader = csv::Reader::from_path(path).while_(what())?;
    let mut rows = Vec::new();
    for row in reader.deserialize() {
        rows.push(row.map_err(|e| Failure(format!("{}: {e}", what())))?);
    }
    Ok(rows)
}
