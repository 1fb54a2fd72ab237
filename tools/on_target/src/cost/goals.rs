//! What was to be reached.

use super::row::Row;

/// Most instructions of a direction, and how many times fewer than with libm.
const M4F: (u64, f64) = (300, 8.0);
const M0: (u64, f64) = (600, 12.0);
const FLASH: u64 = 2048;
const STACK: u64 = 160;

/// The types of integers alone, and the peer that the goals name.
pub(crate) const FIXED: &str = "Fixed";
const FIXED16: &str = "Fixed16";
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
    let wanted = [("M4F", "f32", M4F), ("M0", FIXED, M0), ("M0", FIXED16, M0)];
    for (board, name, (most, times)) in wanted {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn row(name: &str, instructions: u64, flash_bytes: u64) -> Row {
        Row {
            board: "M4F".to_owned(),
            target: String::new(),
            law: "Lambert".to_owned(),
            operation: "sample".to_owned(),
            name: name.to_owned(),
            ours: true,
            format: "f32".to_owned(),
            instructions_least: instructions,
            instructions_mean: instructions as f64,
            instructions_most: instructions,
            flash_bytes,
            stack_bytes: 160,
            ram_bytes: 0,
            words: 3,
            max_ulp: None,
            max_relative: None,
            max_absolute: None,
            rustc: String::new(),
        }
    }

    fn verdicts(ours: u64, libm: u64, flash: u64) -> [&'static str; 4] {
        let goals = all(&[row("f32", ours, flash), row(LIBM, libm, flash)]);
        let of = |what: &str| {
            let goal = goals.iter().find(|g| g.what.contains(what));
            goal.unwrap().verdict()
        };
        [
            of("M4F, `f32`: a `Lambert` direction, `Pcg32`"),
            of("M4F, `f32`: a `Lambert` direction against"),
            of("M4F, `f32`: flash"),
            of("M4F, `f32`: a `Ball` direction, `Pcg32`"),
        ]
    }

    #[test]
    fn a_goal_is_reached_at_its_limit_and_missed_beyond() {
        let absent = "not measured";
        assert_eq!(
            verdicts(300, 2400, 2048),
            ["reached", "reached", "reached", absent]
        );
        assert_eq!(
            verdicts(301, 2400, 2048),
            ["missed", "missed", "reached", absent]
        );
        assert_eq!(
            verdicts(300, 2399, 2049),
            ["reached", "missed", "missed", absent]
        );
    }
}
