//! The rows of the table, and `accuracy_cost.csv` that holds them.

use crate::contender::{Contender, vectors, whole};
use kit::accuracy::rows::{self, law_name};
use kit::study::errors::Errors;
use serde::Serialize;
use std::collections::HashMap;

/// A line of the CSV; its columns are these fields. Relative errors are `inf` where nothing of the
/// value is left.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) law: String,
    /// `warp: cos` and `warp: sin` are one call: two errors, and the same cost twice.
    pub(crate) operation: String,
    /// A number type of ours or a peer.
    pub(crate) name: String,
    /// Of slices: the vectors they are computed in.
    pub(crate) vectors: Option<&'static str>,
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
    /// Nanoseconds of a call, for ratios of calls that have not the same result.
    #[serde(skip)]
    pub(crate) time: f64,
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
            vectors: c.width.map(vectors),
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
            time: own,
            short: c.short.clone(),
        }
    }

    /// The call that the operation is a result of.
    pub(crate) fn call(&self) -> &str {
        self.operation.split(':').next().unwrap_or(&self.operation)
    }

    pub(crate) fn with_judged(mut self, e: &rows::Row) -> Row {
        // Of slices: warp_slice: cos, as warp: cos.
        self.operation = e
            .operation
            .replacen(whole(&self.operation), &self.operation, 1);
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

/// Rows of what was measured: `own` errors are for what no other judge knows. A function of slices
/// has the errors of the scalar call, whose bits it has.
pub(crate) fn rows(
    list: &[Contender],
    counts: &[Option<f64>],
    times: &[f64],
    own: &[Option<Errors>],
    judged: &[rows::Row],
) -> Vec<Row> {
    let scalar: HashMap<_, usize> = list
        .iter()
        .enumerate()
        .filter(|(_, c)| c.ours && c.width.is_none())
        .map(|(i, c)| ((c.name.as_str(), law_name(c.law), c.operation), i))
        .collect();
    let mut all = Vec::new();
    for (i, c) in list.iter().enumerate() {
        let law = law_name(c.law);
        let operation = whole(c.operation);
        let of = |name| scalar.get(&(name, law.clone(), operation)).copied();
        let time = |name| of(name).map_or(f64::NAN, |i| times[i]);
        let row = Row::new(c, counts[i], [times[i], time("f32"), time(c.format)]);
        let results = judged.iter().filter(|e| {
            let call = e.operation.split(':').next();
            c.ours && e.tier == c.name && e.law == law && call == Some(operation)
        });
        let results: Vec<Row> = results.map(|e| row.clone().with_judged(e)).collect();
        let judge = c.width.and_then(|_| of(&c.name)).unwrap_or(i);
        match &own[judge] {
            _ if !results.is_empty() => all.extend(results),
            Some(own) => all.push(row.with_own(own)),
            None => all.push(row),
        }
    }
    all
}

/// Our row of a call in a number type; a function of slices in these vectors.
pub(crate) fn ours<'a>(
    rows: &'a [Row],
    [law, call, name]: [&str; 3],
    vectors: Option<&str>,
) -> Option<&'a Row> {
    let same = |r: &&Row| r.law == law && r.call() == call && r.name == name;
    rows.iter()
        .find(|r| r.ours && r.vectors == vectors && same(r))
}

/// A peer by its name.
pub(crate) fn peer<'a>(rows: &'a [Row], law: &str, call: &str, name: &str) -> Option<&'a Row> {
    rows.iter()
        .find(|r| !r.ours && r.law == law && r.operation == call && r.name == name)
}

/// The quickest peer for an operation of a law, among those of a format if one is said.
pub(crate) fn quickest<'a>(
    rows: &'a [Row],
    law: &str,
    operation: &str,
    format: Option<&str>,
) -> Option<&'a Row> {
    let peers = rows
        .iter()
        .filter(|r| !r.ours && r.law == law && r.operation == operation);
    let peers = peers.filter(|r| format.is_none_or(|f| r.format == f));
    peers.min_by(|a, b| a.time_to_f32.total_cmp(&b.time_to_f32))
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
