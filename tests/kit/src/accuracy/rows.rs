//! The measured table, one row for each number type, law and operation, and its JSON.

use super::format::Format;
use super::inputs::exponents;
use super::measure::{sample, sweep};
use super::op::{OPERATIONS, Op};
use super::reference::Id;
use super::subject::{Subject, Tiers};
use super::tally::{BINS, Stat, Tally};
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
pub fn swept<F: Tiers>(ids: &[Id], stride: u64, progress: impl Fn(u64) + Sync) -> Vec<Row> {
    let subjects = Subject::all(ids);
    let each = |input| sweep(&subjects, input, stride, &progress);
    let tally = Tally::over_inputs(each);
    rows::<F>(&subjects, &tally, stride == 1)
}

/// n stratified numbers of each kind.
pub fn sampled<F: Tiers>(ids: &[Id], n: u64, progress: impl Fn(u64) + Sync) -> Vec<Row> {
    let subjects = Subject::all(ids);
    let each = |input| sample(&subjects, input, n, &progress);
    let tally = Tally::over_inputs(each);
    rows::<F>(&subjects, &tally, false)
}

/// All number types: f32 swept at `stride` (1 is exhaustive), f64 at `samples` stratified inputs of
/// each kind, `CosPower` at a tenth of them for each exponent. `progress` is told of inputs done, in
/// all [`total_inputs`].
pub fn measure_all(stride: u64, samples: u64, progress: impl Fn(u64) + Sync) -> Vec<Row> {
    let mut all = swept::<f32>(&Id::FIXED, stride, &progress);
    all.extend(sampled::<f32>(&exponents::<f32>(), samples / 10, &progress));
    all.extend(sampled::<f64>(&Id::FIXED, samples, &progress));
    all.extend(sampled::<f64>(&exponents::<f64>(), samples / 10, &progress));
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
    (f32::TOP_ANGLE + f32::HALF_BITS) / stride + 2 * (samples + 2 * (samples / 10))
}

pub fn to_json(rows: &[Row]) -> serde_json::Result<String> {
    serde_json::to_string_pretty(rows)
}

pub fn from_json(text: &str) -> serde_json::Result<Vec<Row>> {
    serde_json::from_str(text)
}
