//! What was to be reached.

use super::row::Row;

/// Most instructions of a direction, and how many times fewer than with libm.
const M4F: (u64, f64) = (300, 8.0);
const M0: (u64, f64) = (600, 12.0);
const FLASH: u64 = 2048;
const STACK: u64 = 160;

/// The type of integers alone, and the peer that the goals name.
pub(crate) const FIXED: &str = "Fixed";
pub(crate) const LIBM: &str = "textbook, libm f32";

/// Directions by each generator.
pub(crate) const SAMPLES: [(&str, &str); 2] =
    [("sample", "Pcg32"), ("sample_xorshift", "XorShiftRng")];

/// A goal and how near it is.
pub(crate) struct Goal {
    pub(crate) what: String,
    pub(crate) wanted: String,
    /// None where there is nothing to measure yet.
    pub(crate) found: Option<(String, bool)>,
}

impl Goal {
    pub(crate) fn verdict(&self) -> &'static str {
        match self.found {
            Some((_, true)) => "reached",
            Some((_, false)) => "missed",
            None => "not measured",
        }
    }

    pub(crate) fn line(&self) -> String {
        let found = self.found.as_ref().map_or("nothing", |f| &f.0);
        format!(
            "{}: {}: {found}; wanted {}",
            self.verdict(),
            self.what,
            self.wanted
        )
    }
}

/// Every goal.
pub(crate) fn all(rows: &[Row]) -> Vec<Goal> {
    let mut goals = Vec::new();
    for (board, name, (most, times)) in [("M4F", "f32", M4F), ("M0", FIXED, M0)] {
        let cells = SAMPLES
            .into_iter()
            .flat_map(|sample| ["Lambert", "Ball"].map(|law| (sample, law)));
        for ((operation, generator), law) in cells {
            let find = |name| {
                rows.iter()
                    .find(|r| r.key() == [board, law, operation, name])
            };
            let (own, libm) = (find(name), find(LIBM));
            goals.push(Goal {
                what: format!("{board}, `{name}`: a `{law}` direction, `{generator}` included"),
                wanted: format!("at most {most} instructions"),
                found: own.map(|r| {
                    let n = r.instructions_most;
                    (format!("{n} instructions"), n <= most)
                }),
            });
            goals.push(Goal {
                what: format!("{board}, `{name}`: a `{law}` direction against `libm`'s in `f32`, `{generator}` included"),
                wanted: format!("at least {times} times fewer instructions"),
                found: own.zip(libm).map(|(own, libm)| {
                    let ratio = libm.instructions_mean / own.instructions_mean;
                    (format!("{ratio:.1} times fewer"), ratio >= times)
                }),
            });
        }
        let samples = || {
            rows.iter()
                .filter(move |r| r.board == board && r.name == name && r.operation == "sample")
        };
        let fixed = |r: &&Row| !r.law.starts_with("CosPower");
        let most =
            |bytes: fn(&Row) -> u64| samples().filter(fixed).map(move |r| (bytes(r), &r.law));
        for (what, bytes, limit) in [
            ("flash", (|r| r.flash_bytes) as fn(&Row) -> u64, FLASH),
            ("stack", |r| r.stack_bytes, STACK),
        ] {
            goals.push(Goal {
                what: format!(
                    "{board}, `{name}`: {what} of one law's directions, the six fixed laws"
                ),
                wanted: format!("at most {limit} bytes"),
                found: most(bytes)
                    .max()
                    .map(|(n, law)| (format!("at most {n} bytes ({law})"), n <= limit)),
            });
        }
    }
    goals
}
