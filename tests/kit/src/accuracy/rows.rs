//! The measured table, one row for each number type, law and operation, and its JSON.

use super::format::Format;
use super::inputs::exponents;
use super::measure::{Input, sample, sweep};
use super::op::{OPERATIONS, Op};
use super::part::Part;
use super::reference::Id;
use super::subject::{Subject, Tiers};
use super::tally::{BINS, KEPT, Stat, Tally};
use serde::{Deserialize, Serialize};

/// An error that is infinite, or a NaN result, is written as `f64::MAX`: JSON has no infinity.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Row {
    /// The number type.
    #[serde(rename = "type")]
    pub tier: String,
    /// `CosPower(k)` with its exponent.
    pub law: String,
    pub operation: String,
    pub max_ulp: f64,
    pub inputs: u64,
    /// Every input of the format was tried.
    pub exhaustive: bool,
    pub worst_input_hex: String,
    /// What that input is: theta, tail, cos or sin.
    #[serde(default)]
    pub worst_input_of: String,
    pub worst_input: f64,
    pub correctly_rounded_percent: f64,
    pub misrounded: u64,
    /// The least of them.
    pub misrounded_hex: Vec<String>,
    /// How many true values lay half-way between two numbers.
    pub ties: u64,
    /// Largest |error| over the true value, or over the least normal number where that is larger.
    pub max_relative: f64,
    /// The same of the tail: inputs p, θ or π/2 − θ of at most 2⁻²⁰.
    pub max_relative_tail: f64,
    /// The same by the size of p, or of the smaller of θ and π/2 − θ.
    pub decades: Vec<Decade>,
}

/// The largest relative error where 10^`from` < distance ≤ 10^`to`; the last goes down to 0.
/// Written as `[from, to, max_relative]`, read with the names too.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(into = "(i32, i32, f64)")]
pub struct Decade {
    pub from: i32,
    pub to: i32,
    pub max_relative: f64,
}

impl From<Decade> for (i32, i32, f64) {
    fn from(d: Decade) -> Self {
        (d.from, d.to, d.max_relative)
    }
}

/// A row's type, law and operation.
pub type Key = [String; 3];

/// The law's name in the rows.
pub fn law_name(id: Id) -> String {
    match id {
        Id::CosPower(k) => format!("CosPower({k:e})"),
        id => id.name().to_owned(),
    }
}

impl Row {
    pub fn key(&self) -> Key {
        [&self.tier, &self.law, &self.operation].map(Clone::clone)
    }

    /// With the same row of the next part: what one run over both would have written.
    pub fn merge(mut self, next: Row) -> Self {
        // A run over both judges all of one kind of input before the next kind.
        let kind = |row: &Row| {
            Input::ALL
                .iter()
                .position(|i| i.name() == row.worst_input_of)
        };
        if next.max_ulp > self.max_ulp || next.max_ulp == self.max_ulp && kind(&next) < kind(&self)
        {
            self.max_ulp = next.max_ulp;
            self.worst_input_hex = next.worst_input_hex;
            self.worst_input_of = next.worst_input_of;
            self.worst_input = next.worst_input;
        }
        self.inputs += next.inputs;
        self.misrounded += next.misrounded;
        let correct = (self.inputs - self.misrounded) as f64;
        self.correctly_rounded_percent = 100.0 * correct / self.inputs as f64;
        self.misrounded_hex.extend(next.misrounded_hex);
        let value = |hex: &String| u64::from_str_radix(hex.trim_start_matches("0x"), 16).ok();
        self.misrounded_hex.sort_by_key(value);
        self.misrounded_hex.dedup();
        self.misrounded_hex.truncate(KEPT);
        self.ties += next.ties;
        self.max_relative = self.max_relative.max(next.max_relative);
        self.max_relative_tail = self.max_relative_tail.max(next.max_relative_tail);
        for decade in next.decades {
            match self.decades.iter_mut().find(|d| d.from == decade.from) {
                Some(d) => d.max_relative = d.max_relative.max(decade.max_relative),
                None => self.decades.push(decade),
            }
        }
        self.decades.sort_by_key(|d| -d.from);
        self
    }

    fn new<F: Format>(s: &Subject<F>, operation: &str, stat: &Stat, exhaustive: bool) -> Self {
        let finite = |x: f64| x.min(f64::MAX);
        let width = F::BIN as i32;
        let decades = (0..BINS as i32).zip(stat.bins).filter(|(_, x)| *x >= 0.0);
        Row {
            tier: s.tier.to_owned(),
            law: law_name(s.id),
            operation: operation.to_owned(),
            max_ulp: finite(stat.ulps),
            inputs: stat.tried,
            exhaustive,
            worst_input_hex: format!("{:#x}", stat.input),
            worst_input_of: stat.of.name().to_owned(),
            worst_input: F::of_bits(stat.input).wide(),
            correctly_rounded_percent: 100.0 * stat.correct as f64 / stat.tried as f64,
            misrounded: stat.misrounded_count(),
            misrounded_hex: stat.misrounded.iter().map(|i| format!("{i:#x}")).collect(),
            ties: stat.ties,
            max_relative: finite(stat.relative),
            max_relative_tail: finite(stat.relative_tail),
            decades: decades
                .map(|(i, x)| Decade {
                    from: -(i + 1) * width,
                    to: -i * width,
                    max_relative: finite(x),
                })
                .collect(),
        }
    }
}

fn rows<F: Format>(subjects: &[Subject<F>], tally: &Tally, exhaustive: bool) -> Vec<Row> {
    let mut all = Vec::new();
    for (s, stats) in subjects.iter().zip(&tally.0) {
        for ((_, name), stat) in OPERATIONS.iter().zip(stats) {
            if stat.tried > 0 {
                all.push(Row::new(s, name, stat, exhaustive));
            }
        }
    }
    all
}

/// Every `stride`-th number.
pub fn swept<F: Tiers>(
    ids: &[Id],
    stride: u64,
    part: Part,
    progress: impl Fn(u64) + Sync,
) -> Vec<Row> {
    let subjects = Subject::all(ids);
    let each = |input| sweep(&subjects, input, stride, part, &progress);
    let tally = Tally::over_inputs(each);
    rows::<F>(&subjects, &tally, stride == 1)
}

/// n stratified numbers of each kind.
pub fn sampled<F: Tiers>(
    ids: &[Id],
    n: u64,
    part: Part,
    progress: impl Fn(u64) + Sync,
) -> Vec<Row> {
    let subjects = Subject::all(ids);
    let each = |input| sample(&subjects, input, n, part, &progress);
    let tally = Tally::over_inputs(each);
    rows::<F>(&subjects, &tally, false)
}

/// All number types: f32 swept at `stride` (1 is exhaustive), f64 at `samples` stratified inputs of
/// each kind, `CosPower` at a tenth of them for each exponent. `progress` is told of inputs done,
/// in all [`total_inputs`], a part its share.
pub fn measure_all(
    stride: u64,
    samples: u64,
    part: Part,
    progress: impl Fn(u64) + Sync,
) -> Vec<Row> {
    let mut all = swept::<f32>(&Id::FIXED, stride, part, &progress);
    all.extend(sampled::<f32>(
        &exponents::<f32>(),
        samples / 10,
        part,
        &progress,
    ));
    all.extend(sampled::<f64>(&Id::FIXED, samples, part, &progress));
    all.extend(sampled::<f64>(
        &exponents::<f64>(),
        samples / 10,
        part,
        &progress,
    ));
    all
}

/// The keys of the rows of [`measure_all`], in its order.
pub fn keys() -> Vec<Key> {
    fn of<F: Tiers>(keys: &mut Vec<Key>) {
        for s in Subject::<F>::all(&[&Id::FIXED[..], &exponents::<F>()].concat()) {
            let has = |op| op != Op::PdfSolidAngle || s.solid;
            let operations = OPERATIONS.iter().filter(|(op, _)| has(*op));
            keys.extend(
                operations.map(|(_, name)| [s.tier, &law_name(s.id), name].map(Into::into)),
            );
        }
    }
    let mut keys = Vec::new();
    of::<f32>(&mut keys);
    of::<f64>(&mut keys);
    keys
}

/// Inputs that [`measure_all`] visits, up to rounding.
pub fn total_inputs(stride: u64, samples: u64) -> u64 {
    let swept: u64 = Input::ALL.iter().map(|i| i.top::<f32>() / stride).sum();
    swept + Input::ALL.len() as u64 * (samples + 2 * (samples / 10))
}

pub fn to_json(rows: &[Row]) -> serde_json::Result<String> {
    serde_json::to_string_pretty(rows)
}

pub fn from_json(text: &str) -> serde_json::Result<Vec<Row>> {
    serde_json::from_str(text)
}
