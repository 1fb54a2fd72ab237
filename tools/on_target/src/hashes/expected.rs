//! The committed hashes, one a line: law, number type, stream, count, hash of the first so many
//! results.

use crate::build::workspace;
use crate::failure::{Failure, Result, While};
use crate::types::TYPES;
use kit::Stream;
use output::{File, say};
use std::fs;
use std::path::PathBuf;

/// The file's text.
pub(super) struct Expected(String);

fn file() -> PathBuf {
    workspace().join("hashes.txt")
}

impl Expected {
    pub(super) fn read() -> Result<Self> {
        let file = file();
        let text = fs::read_to_string(&file).while_(file.display())?;
        for (number, line) in text.lines().enumerate() {
            if parse(line).is_none() {
                return Err(Failure(format!(
                    "{}:{}: expected LAW TYPE samples|values COUNT HASH, found {line:?}",
                    file.display(),
                    number + 1
                )));
            }
        }
        Ok(Expected(text))
    }

    /// A subject's lines up to a count.
    pub(super) fn lines(
        &self,
        law: &str,
        number: &str,
        stream: Stream,
        last: u32,
    ) -> Result<String> {
        let lines: String = self
            .0
            .lines()
            .filter(|line| {
                parse(line).is_some_and(|(l, n, s, count)| {
                    (l, n, s) == (law, number, stream) && count <= last
                })
            })
            .map(|line| format!("{line}\n"))
            .collect();
        if lines.is_empty() {
            return Err(Failure(format!(
                "{}: no line for {law} {number} {stream} up to {last}; --bless writes them",
                file().display()
            )));
        }
        Ok(lines)
    }
}

/// (law, number type, stream, count)
pub(super) fn parse(line: &str) -> Option<(&str, &str, Stream, u32)> {
    let mut words = line.split(' ');
    let subject = (words.next()?, words.next()?);
    let stream = Stream::named(words.next()?)?;
    let count = words.next()?.parse().ok()?;
    let hash = words.next()?;
    let complete = hash.len() == 16 && u64::from_str_radix(hash, 16).is_ok();
    (complete && words.next().is_none()).then_some((subject.0, subject.1, stream, count))
}

/// Writes the file anew.
pub(super) fn write(of: impl Fn(&str, Stream) -> Result<String>) -> Result<()> {
    let file = file();
    let out = File::check(&file, &[]).map_err(Failure)?;
    let mut text = String::new();
    for number in TYPES {
        for stream in Stream::ALL {
            text += &of(number, stream)?;
        }
    }
    out.write(text.as_bytes()).map_err(Failure)?;
    say(format_args!(
        "wrote {}: mark the change \"value-breaking\"",
        file.display()
    ));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_found_by_all_that_they_name() {
        let text = "Ball f32 samples 64 00000000000000aa\n\
                    Ball f32 samples 256 00000000000000bb\n\
                    Ball f32 values 64 00000000000000cc\n\
                    Ball f64 samples 64 00000000000000dd\n";
        let expected = Expected(text.to_owned());
        let lines = expected.lines("Ball", "f32", Stream::Samples, 64);
        assert_eq!(lines.unwrap(), "Ball f32 samples 64 00000000000000aa\n");
        let lines = expected.lines("Ball", "f32", Stream::Samples, 256).unwrap();
        assert_eq!(lines.lines().count(), 2);
        assert!(expected.lines("Disk", "f32", Stream::Samples, 64).is_err());
    }

    #[test]
    fn spoiled_lines_are_refused() {
        let good = "Ball Precise<f32> values 64 00000000000000cc";
        assert_eq!(
            parse(good),
            Some(("Ball", "Precise<f32>", Stream::Values, 64))
        );
        for bad in [
            "",
            "Ball f32 samples 64",
            "Ball f32 samples 64 cc",
            "Ball f32 sample 64 00000000000000cc",
            "Ball f32 samples -1 00000000000000cc",
            "Ball f32 samples 64 00000000000000cg",
            "Ball f32 samples 64 00000000000000cc x",
        ] {
            assert_eq!(parse(bad), None, "{bad}");
        }
    }
}
