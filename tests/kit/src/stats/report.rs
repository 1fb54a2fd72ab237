//! p-values of one subject, and the verdict.

/// False-alarm probability of one whole run of all tests.
const FAMILY: f64 = 1e-4;

/// At least the number of p-values in one run, opt-in tests included.
const TESTS: f64 = 2048.0;

/// Šidák's threshold of a single p-value: 1 − (1 − `FAMILY`)^(1/`TESTS`).
pub fn threshold() -> f64 {
    -((-FAMILY).ln_1p() / TESTS).exp_m1()
}

pub struct Report {
    subject: String,
    results: Vec<(&'static str, f64)>,
    fatal: Option<String>,
}

impl Report {
    pub fn new(subject: String) -> Self {
        Report {
            subject,
            results: Vec::new(),
            fatal: None,
        }
    }

    pub fn add(&mut self, test: &'static str, p: f64) {
        if p.is_nan() {
            self.fatal(format!("{test}: the p-value is NaN"));
        }
        self.results.push((test, p));
    }

    /// What no number of samples excuses. The first one is kept.
    pub fn fatal(&mut self, what: String) {
        self.fatal.get_or_insert(what);
    }

    fn smallest(&self) -> (&'static str, f64) {
        let none = ("no test", 1.0);
        self.results
            .iter()
            .fold(none, |a, &b| if b.1 < a.1 { b } else { a })
    }

    pub fn accepted(&self) {
        let (test, p) = self.smallest();
        println!("{}: smallest p {p:.3e} ({test})", self.subject);
        if let Some(what) = &self.fatal {
            panic!("{}: {what}", self.subject);
        }
        assert!(
            p > threshold(),
            "{}: {test} rejects with p = {p:e}, threshold {:e}",
            self.subject,
            threshold()
        );
    }

    /// As [`accepted`](Report::accepted), but for a test that does not apply to the subject.
    pub fn without(mut self, test: &str) -> Self {
        self.results.retain(|result| result.0 != test);
        self
    }

    /// Whether the test named rejects by itself: otherwise it would not earn its place.
    pub fn rejects(&self, test: &str) -> bool {
        let found = self.results.iter().find(|result| result.0 == test);
        let (_, p) = found.unwrap_or_else(|| panic!("no test is called {test}"));
        println!("{}: {test} p {p:.3e}", self.subject);
        *p < threshold()
    }

    pub fn is_fatal(&self) -> bool {
        println!("{}: {:?}", self.subject, self.fatal);
        self.fatal.is_some()
    }
}
