//! The errors of the accuracy study, joined to what the boards count by type, law and operation.

use crate::failure::{Failure, Result, While};
use serde::Deserialize;
use std::collections::HashMap;
use std::path::Path;

/// What the study knows of an operation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Known {
    pub(crate) max_ulp: Option<f64>,
    pub(crate) max_relative: Option<f64>,
}

#[derive(Deserialize)]
struct Line {
    law: String,
    operation: String,
    name: String,
    max_ulp: Option<f64>,
    max_relative: Option<f64>,
}

/// `docs/measured/accuracy_cost.csv`.
#[derive(Default)]
pub(crate) struct Study(HashMap<[String; 3], Known>);

impl Study {
    pub(crate) fn read(path: &Path) -> Result<Study> {
        let text = std::fs::read_to_string(path).while_(format!("reading {}", path.display()))?;
        Study::parse(&text).map_err(|e| Failure(format!("{}: {e}", path.display())))
    }

    pub(crate) fn parse(text: &str) -> std::result::Result<Study, String> {
        let mut all: HashMap<[String; 3], Known> = HashMap::new();
        let worse = |a: Option<f64>, b: Option<f64>| match (a, b) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
        for line in csv::Reader::from_reader(text.as_bytes()).deserialize() {
            let line: Line = line.map_err(|e| e.to_string())?;
            // `warp: cos` and `warp: sin` are one call, as wrong as the worse of them.
            let call = line.operation.split(':').next().unwrap_or_default();
            let known = all
                .entry([line.law, call.to_owned(), line.name])
                .or_default();
            known.max_ulp = worse(known.max_ulp, line.max_ulp);
            known.max_relative = worse(known.max_relative, line.max_relative);
        }
        if all.is_empty() {
            return Err("no rows; expected those of `-p accuracy_cost`".to_owned());
        }
        Ok(Study(all))
    }

    /// Nothing is known of what the study has not.
    pub(crate) fn find(&self, law: &str, operation: &str, name: &str) -> Known {
        let key = [law, operation, name].map(str::to_owned);
        self.0.get(&key).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "law,operation,name,max_ulp,max_relative,next_u32,next_u64\n";

    #[test]
    fn rows_are_joined_by_call() {
        let text = format!(
            "{HEAD}Ball,warp: cos,f32,1.5,2e-7,,\nBall,warp: sin,f32,2.5,1e-7,,\n\
             Ball,sample,f32,,3e-7,1.0,1.0\nBall,sample,\"powf, libm f32\",,inf,2.0,0.0\n"
        );
        let study = Study::parse(&text).unwrap();
        let warp = study.find("Ball", "warp", "f32");
        assert_eq!((warp.max_ulp, warp.max_relative), (Some(2.5), Some(2e-7)));
        assert_eq!(study.find("Ball", "sample", "f32").max_ulp, None);
        let peer = study.find("Ball", "sample", "powf, libm f32");
        assert_eq!(peer.max_relative, Some(f64::INFINITY));
        assert_eq!(study.find("Ball", "warp", "f64"), Known::default());
    }

    /// A column that is gone, a number that is none, a table with no rows.
    #[test]
    fn planted_mistakes_are_caught() {
        let fault = |text: &str| Study::parse(text).err().unwrap();
        assert!(fault(HEAD).contains("no rows"));
        let gone = format!("{}Ball,pdf,1,1,,\n", HEAD.replace("name,", ""));
        assert!(fault(&gone).contains("name"));
        let none = format!("{HEAD}Ball,pdf,f32,many,,,\n");
        assert!(fault(&none).contains("line: 2"));
    }
}
