//! What is wrong with a scene file: where, and what was expected.

use std::fmt;
use std::ops::Range;

/// `file:line:column: what; expected …`
#[derive(Debug)]
pub struct Error(String);

impl Error {
    pub fn new(name: &str, text: &str, span: Range<usize>, what: String) -> Error {
        let before = text.get(..span.start).unwrap_or(text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        Error(format!("{name}:{line}:{column}: {what}"))
    }

    /// What the parser says, on one line: its messages name what it expected.
    pub fn of_toml(name: &str, text: &str, e: &toml::de::Error) -> Error {
        let what = e.message().trim().replace('\n', "; ");
        Error::new(name, text, e.span().unwrap_or(0..0), what)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}
