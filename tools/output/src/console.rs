//! Text for a terminal that may be none: a closed pipe, a full device.

use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;
use std::sync::OnceLock;

/// Why standard output took no more.
static LOST: OnceLock<String> = OnceLock::new();

/// Prints a line. What cannot be printed stops no work: [`exit_code`] says so in the end.
pub fn say(text: impl Display) {
    if LOST.get().is_some() {
        return;
    }
    if let Err(e) = writeln!(io::stdout(), "{text}") {
        let _ = LOST.set(e.to_string());
    }
}

/// Prints a line to standard error, if it can be.
pub fn warn(text: impl Display) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// The end of the program `name`: an error in one line, or that standard output was lost.
pub fn exit_code(name: &str, done: Result<(), impl Display>) -> ExitCode {
    let lost = io::stdout().flush().err().map(|e| e.to_string());
    match (done, LOST.get().cloned().or(lost)) {
        (Err(e), _) => warn(format_args!("{name}: {}", plain(e))),
        (Ok(()), Some(e)) => warn(format_args!(
            "{name}: standard output took no more: {e}; all else is done"
        )),
        (Ok(()), None) => return ExitCode::SUCCESS,
    }
    ExitCode::FAILURE
}

/// Text from outside as one line: what a terminal would obey, or that would turn the direction of
/// writing, is spelled out.
pub fn plain(text: impl Display) -> String {
    let mut plain = String::new();
    for c in text.to_string().chars() {
        if c.is_control() || turns(c) {
            plain.extend(c.escape_default());
        } else {
            plain.push(c);
        }
    }
    plain
}

/// Whether it breaks a line or turns the direction of writing, though it is no control character.
fn turns(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}')
        || ('\u{2028}'..='\u{202e}').contains(&c)
        || ('\u{2066}'..='\u{2069}').contains(&c)
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn what_a_terminal_obeys_is_spelled_out() {
        assert_eq!(plain("a\x1b[31mb\nc\u{9b}d"), "a\\u{1b}[31mb\\nc\\u{9b}d");
        assert_eq!(plain("\u{202e}txt"), "\\u{202e}txt");
        assert_eq!(plain("cos θ ≤ ½ – “ß”"), "cos θ ≤ ½ – “ß”");
    }
}
