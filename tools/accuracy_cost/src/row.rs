//! The rows of the table, and `accuracy_cost.csv` that holds them.

use crate::contender::Contender;
use kit::accuracy::rows;
use kit::study::errors::Errors;
use serde::Serialize;

/// A line of the CSV; its columns are these fields. Relative errors are `inf` where nothing of the
/// value is left.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) law: String,
    /// `warp: cos` and `warp: sin` are one call: two errors, and the same cost twice.
    pub(crate) operation: String,
    /// A number type of ours or a peer.
    pub(crate) name: String,
    pub(crate) ours: bool,
    pub(crate) format: String,
    pub(crate) max_ulp: Option<f64>,
    pub(crate) inputs: Option<u64>,
    pub(crate) exhaustive: Option<bool>,
    pub(crate) worst_input_hex: Option<String>,
    pub(crate) correctly_rounded_percent: Option<f64>,
    pub(crate) misrounded: Option<u64>,
    pub(crate) max_relative: Option<f64>,
    pub(crate) max_relative_tail: Option<f64>,
    /// Mean instructions of a call.
    pub(crate) instructions: Option<f64>,
    /// Time of a call as a multiple of `f32`'s, and of the plain type's of the same format.
    pub(crate) time_to_f32: f64,
    pub(crate) time_to_plain: f64,
    pub(crate) next_u32: Option<f64>,
    pub(crate) next_u64: Option<f64>,
    /// The name in a plot.
    #[serde(skip)]
    pub(crate) short: String,
}

impl Row {
    /// With no errors yet. Times are those of the contender, of `f32` and of the plain type.
    pub(crate) fn new(c: &Contender, instructions: Option<f64>, times: [f64; 3]) -> Row {
        let words = c.cell.words;
        let [own, single, plain] = times;
        Row {
            law: c.law.to_string(),
            operation: c.operation.to_owned(),
            name: c.name.clone(),
            ours: c.ours,
            format: c.format.to_owned(),
            max_ulp: None,
            inputs: None,
            exhaustive: None,
            worst_input_hex: None,
            correctly_rounded_percent: None,
            misrounded: None,
            max_relative: None,
            max_relative_tail: None,
            instructions,
            time_to_f32: own / single,
            time_to_plain: own / plain,
            next_u32: words.map(|w| w.next_u32),
            next_u64: words.map(|w| w.next_u64),
            short: c.short.clone(),
        }
    }

    /// The call that the operation is a result of.
    pub(crate) fn call(&self) -> &str {
        self.operation.split(':').next().unwrap_or(&self.operation)
    }

    pub(crate) fn with_judged(mut self, e: &rows::Row) -> Row {
        self.operation = e.operation.clone();
        self.max_ulp = Some(e.max_ulp);
        self.inputs = Some(e.inputs);
        self.exhaustive = Some(e.exhaustive);
        self.worst_input_hex = Some(e.worst_input_hex.clone());
        self.correctly_rounded_percent = Some(e.correctly_rounded_percent);
        self.misrounded = Some(e.misrounded);
        self.max_relative = Some(e.max_relative);
        self.max_relative_tail = Some(e.max_relative_tail);
        self
    }

    /// Of a sample or a peer, which have no other judge.
    pub(crate) fn with_own(mut self, e: &Errors) -> Row {
        self.inputs = Some(e.inputs);
        self.exhaustive = Some(false);
        self.max_relative = Some(e.worst());
        self.max_relative_tail = e.in_tail;
        self
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
