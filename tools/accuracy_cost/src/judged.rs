//! The errors of our own operations: measured as the tests measure them, or read from a file.

use kit::Number;
use kit::accuracy::monotone;
use kit::accuracy::part::Part;
use kit::accuracy::reference::Id;
use kit::accuracy::rows::{Key, Row, keys, measure_all};
use kit::accuracy::subject::{Subject, Tiers};
use kit::promises_ulps;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// The file in the folder of the tables.
pub(crate) const FILE: &str = "accuracy_errors.json";

/// How often the quantiles of a law step back.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Quantiles {
    #[serde(rename = "type")]
    pub(crate) tier: String,
    pub(crate) law: String,
    pub(crate) inputs: u64,
    pub(crate) exhaustive: bool,
    /// Neighbours p where `quantile` or `isf` steps back or, for a planar law, fails to mirror.
    pub(crate) steps_back: u64,
    /// The least such p.
    pub(crate) first_hex: Option<String>,
}

impl Quantiles {
    /// With those of the next part.
    pub(crate) fn merge(mut self, next: Quantiles) -> Self {
        self.inputs += next.inputs;
        self.steps_back += next.steps_back;
        let value = |hex: &String| u64::from_str_radix(hex.trim_start_matches("0x"), 16).ok();
        let both = self.first_hex.into_iter().chain(next.first_hex);
        self.first_hex = both.min_by_key(value);
        self
    }
}

#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Judged {
    pub(crate) errors: Vec<Row>,
    pub(crate) quantiles: Vec<Quantiles>,
}

/// Every operation of every law in every type; all but f32's fixed laws by samples.
pub(crate) fn measure(
    stride: u64,
    samples: u64,
    part: Part,
    step: impl Fn(u64) + Sync,
) -> Vec<Row> {
    measure_all(stride, samples, part, step)
}

/// Quantiles of the fixed laws: every `stride`-th p of f32, `samples` of f64. `step` hears of each.
pub(crate) fn quantiles(stride: u64, samples: u64, part: Part, step: impl Fn()) -> Vec<Quantiles> {
    let mut all = Vec::new();
    let mut push = |tier: &str, id: Id, inputs, exhaustive, (steps_back, first): (u64, u64)| {
        step();
        all.push(Quantiles {
            tier: tier.to_owned(),
            law: id.name().to_owned(),
            inputs,
            exhaustive,
            steps_back,
            first_hex: (steps_back > 0).then(|| format!("{first:#x}")),
        });
    };
    for s in promising::<f32>() {
        let share = part.share(f32::of(1.0).bits() / stride);
        let inputs = share.end - share.start;
        let found = monotone::strided(&s, stride, part);
        push(s.tier, s.id, inputs, stride == 1, found);
    }
    for s in promising::<f64>() {
        let share = part.share(samples - samples % 3);
        let found = monotone::sampled(&s, samples, part);
        push(s.tier, s.id, share.end - share.start, false, found);
    }
    all
}

/// The fixed laws in the types whose quantiles are not to step back.
fn promising<F: Tiers>() -> impl Iterator<Item = Subject<F>> {
    let all = Subject::<F>::all(&Id::FIXED).into_iter();
    all.filter(|s| promises_ulps(s.tier))
}

/// Type and law of all [`quantiles`].
pub(crate) fn quantile_keys() -> Vec<Key> {
    let key = |tier: &str, id: Id| [tier, id.name(), "quantile"].map(str::to_owned);
    let single = promising::<f32>().map(|s| key(s.tier, s.id));
    single
        .chain(promising::<f64>().map(|s| key(s.tier, s.id)))
        .collect()
}

/// One row a line: git shows what changed.
pub(crate) fn to_json(judged: &Judged) -> serde_json::Result<String> {
    fn lines<T: Serialize>(all: &[T]) -> serde_json::Result<String> {
        let lines: Result<Vec<_>, _> = all.iter().map(serde_json::to_string).collect();
        Ok(lines?.join(",\n"))
    }
    Ok(format!(
        "{{\"errors\": [\n{}\n],\n\"quantiles\": [\n{}\n]}}\n",
        lines(&judged.errors)?,
        lines(&judged.quantiles)?
    ))
}

/// The rows of a file and, if it has them, the quantiles; refused unless they are all that
/// [`measure`] gives and no more.
pub(crate) fn read(path: &Path) -> Result<(Vec<Row>, Option<Vec<Quantiles>>), String> {
    let explain = |e: &dyn std::fmt::Display| {
        format!(
            "{}: {e}; expected {FILE} as a run without --keep-errors writes it, or the rows of \
             tests/kit/src/accuracy/rows.rs as JSON",
            path.display()
        )
    };
    let text = std::fs::read_to_string(path).map_err(|e| explain(&e))?;
    let value: Value = serde_json::from_str(&text).map_err(|e| explain(&e))?;
    // Bare rows are what `rows::to_json` writes.
    let (rows, quantiles): (Vec<Row>, _) = if value.is_array() {
        (
            serde_json::from_value(value).map_err(|e| explain(&e))?,
            None,
        )
    } else {
        let judged: Judged = serde_json::from_value(value).map_err(|e| explain(&e))?;
        (judged.errors, Some(judged.quantiles))
    };
    complete(&keys(), &rows.iter().map(Row::key).collect::<Vec<_>>()).map_err(|e| explain(&e))?;
    if let Some(found) = &quantiles {
        let key = |q: &Quantiles| [q.tier.clone(), q.law.clone(), "quantile".to_owned()];
        let found: Vec<_> = found.iter().map(key).collect();
        complete(&quantile_keys(), &found).map_err(|e| explain(&e))?;
    }
    Ok((rows, quantiles))
}

/// Whether each wanted key is found once, and no other.
fn complete(wanted: &[Key], found: &[Key]) -> Result<(), String> {
    let mut balance: BTreeMap<&Key, i32> = BTreeMap::new();
    wanted
        .iter()
        .for_each(|k| *balance.entry(k).or_default() += 1);
    found
        .iter()
        .for_each(|k| *balance.entry(k).or_default() -= 1);
    let differing = |wrong: fn(i32) -> bool, what: &str| {
        let keys: Vec<_> = balance.iter().filter(|(_, n)| wrong(**n)).collect();
        let (first, _) = keys.first()?;
        let count = keys.len();
        Some(format!("{count} {what}, such as {}", first.join(" ")))
    };
    let faults = [
        differing(|n| n > 0, "are missing"),
        differing(|n| n < 0, "are unknown or there twice"),
    ];
    let faults: Vec<String> = faults.into_iter().flatten().collect();
    if faults.is_empty() {
        Ok(())
    } else {
        Err(format!("of {} rows, {}", wanted.len(), faults.join("; ")))
    }
}
