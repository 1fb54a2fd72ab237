//! What `tools/scipy_peer.py` found, from `scipy.csv`.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// A line of the file: a quantity of a function, in a decade of u where it has one.
#[derive(Debug, Deserialize)]
struct Record {
    quantity: String,
    function: String,
    decade: Option<i32>,
    value: String,
}

#[derive(Debug, Default)]
pub(crate) struct Scipy {
    pub(crate) version: String,
    pub(crate) elements: String,
    /// Time of a function as a multiple of `Disk.quantile`'s.
    pub(crate) time: Vec<(String, f64)>,
    /// Worst relative errors by decade of u: quantity, function → decade → error.
    pub(crate) errors: BTreeMap<(String, String), BTreeMap<i32, f64>>,
}

/// The name of our own function in the file.
pub(crate) const OURS: &str = "coslobe Disk f64";

/// Reads the file; `None` if there is none.
pub(crate) fn read(path: &Path) -> Result<Option<Scipy>, String> {
    if !path.exists() {
        return Ok(None);
    }
    let mut scipy = Scipy::default();
    let shape = "expected quantity,function,decade,value as tools/scipy_peer.py writes them";
    let explain = |e: csv::Error| {
        let line = e.position().map_or(1, csv::Position::line);
        format!("{}:{line}: {e}; {shape}", path.display())
    };
    let mut reader = csv::Reader::from_path(path).map_err(explain)?;
    let headers = reader.headers().map_err(explain)?.clone();
    for record in reader.records() {
        let record = record.map_err(explain)?;
        let line = record.position().map_or(0, csv::Position::line);
        let Record {
            quantity,
            function,
            decade,
            value,
        } = record.deserialize(Some(&headers)).map_err(explain)?;
        let number = || {
            let wrong = |_| format!("{}:{line}: value {value:?}; {shape}", path.display());
            value.parse::<f64>().map_err(wrong)
        };
        match (quantity.as_str(), decade) {
            ("version", _) => scipy.version = value,
            ("elements", _) => scipy.elements = value,
            ("time_ratio", _) => scipy.time.push((function, number()?)),
            ("relative_theta" | "relative_cos", Some(decade)) => {
                let number = number()?;
                let curve = scipy.errors.entry((quantity, function)).or_default();
                curve.insert(decade, number);
            }
            _ => return Err(format!("{}:{line}: {quantity:?}; {shape}", path.display())),
        }
    }
    Ok(Some(scipy))
}
