//! What `tools/mitsuba_peer.py` found, from `mitsuba.csv`.

use serde::Deserialize;
use std::path::Path;

#[derive(Deserialize)]
struct Record {
    quantity: String,
    function: String,
    value: String,
}

/// Ours over Mitsuba's, of the same points at the same width.
pub(crate) struct Mitsuba {
    pub(crate) version: String,
    pub(crate) time: f64,
    /// Worst error of a component.
    pub(crate) component: f64,
    /// Worst relative error of cos θ.
    pub(crate) cos: f64,
}

/// Reads the file in the folder; `None` if there is none.
pub(crate) fn read(folder: &Path) -> Result<Option<Mitsuba>, String> {
    let path = folder.join("mitsuba.csv");
    if !path.exists() {
        return Ok(None);
    }
    let explain = |e: &dyn std::fmt::Display| {
        format!(
            "{}: {e}; expected quantity,function,value as tools/mitsuba_peer.py writes them",
            path.display()
        )
    };
    let reader = csv::Reader::from_path(&path).map_err(|e| explain(&e))?;
    let records: Result<Vec<Record>, _> = reader.into_deserialize().collect();
    let records = records.map_err(|e| explain(&e))?;
    let value = |quantity: &str, function: &str| {
        let same = |r: &&Record| r.quantity == quantity && r.function.starts_with(function);
        let found = records.iter().find(same);
        found.ok_or_else(|| explain(&format!("no {quantity} of {function}")))
    };
    let number = |quantity: &str, function: &str| {
        let record = value(quantity, function)?;
        record.value.parse::<f64>().map_err(|e| explain(&e))
    };
    let over = |quantity: &str| {
        Ok::<f64, String>(number(quantity, "coslobe")? / number(quantity, "mitsuba")?)
    };
    Ok(Some(Mitsuba {
        version: value("version", "mitsuba")?.value.clone(),
        time: number("time_ratio", "coslobe")?,
        component: over("worst_component")?,
        cos: over("worst_relative_cos")?,
    }))
}
