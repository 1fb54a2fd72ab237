//! From a checkpoint whose hash differs to the first result that does.

use super::ask::Asked;
use super::expected::parse;
use crate::difference::first;
use crate::failure::{Failure, Result};
use kit::{CHECKPOINTS, Stream};

/// Blocks that are hashed at once.
const BLOCKS: u32 = 64;

/// The input of the first result that differs before the count of `line`, and both bit patterns.
pub(super) fn cause(
    host: &impl Asked,
    other: &impl Asked,
    law: &str,
    stream: Stream,
    line: &str,
) -> Result<String> {
    let to = parse(line).map_or(stream.length(), |l| l.3);
    let from = CHECKPOINTS.into_iter().rfind(|&c| c < to).unwrap_or(0);
    let Some(index) = index(host, other, law, stream, from, to)? else {
        return Ok(
            "The host computes what it did not when the hashes were written, or its own hash of \
                   each block is the same: a value-breaking change."
                .to_owned(),
        );
    };
    let request = [law, stream.name(), "results", &index.to_string()];
    Ok(results(&host.ask(&request)?, &other.ask(&request)?))
}

/// Where in `from..to` the first difference lies.
fn index(
    host: &impl Asked,
    other: &impl Asked,
    law: &str,
    stream: Stream,
    mut from: u32,
    mut to: u32,
) -> Result<Option<u32>> {
    loop {
        let step = (to - from).div_ceil(BLOCKS).max(1);
        let numbers = [from, to, step].map(|n| n.to_string());
        let request = [
            law,
            stream.name(),
            "blocks",
            &numbers[0],
            &numbers[1],
            &numbers[2],
        ];
        let (expected, found) = (host.ask(&request)?, other.ask(&request)?);
        let Some((expected, found)) = first(&expected, &found) else {
            return Ok(None);
        };
        let start = parse(expected).ok_or_else(|| {
            Failure(format!(
                "blocks differ in number: expected {expected}\n   found {found}"
            ))
        })?;
        (from, to) = (start.3, to.min(start.3 + step));
        if step == 1 {
            return Ok(Some(from));
        }
    }
}

/// The inputs, and what differs.
fn results(expected: &str, found: &str) -> String {
    let mut text = String::new();
    for (expected, found) in expected.lines().zip(found.lines()) {
        if expected != found {
            text += &format!("expected {expected}\n   found {found}\n");
        } else if is_input(expected) {
            text += &format!("of       {expected}\n");
        }
    }
    text
}

/// Whether a line of results says what the operations were given.
fn is_input(line: &str) -> bool {
    [" x = ", " y = ", " word = "]
        .iter()
        .any(|name| line.contains(name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use kit::Hash;

    /// Results that are their own index, but for one.
    struct Fake {
        wrong: Option<u32>,
    }

    impl Fake {
        fn at(&self, index: u32) -> u64 {
            u64::from(index) << 1 | u64::from(self.wrong == Some(index))
        }
    }

    impl Asked for Fake {
        fn ask(&self, request: &[&str]) -> Result<String> {
            let [law, stream, task, numbers @ ..] = request else {
                return Err(Failure("too short".to_owned()));
            };
            let n: Vec<u32> = numbers.iter().map(|n| n.parse().unwrap()).collect();
            if *task == "results" {
                let input = format!("{law} f32 {stream} {} x = 0x7", n[0]);
                return Ok(format!(
                    "{input}\n{law} f32 {stream} {} pdf(x) = {:#x}\n",
                    n[0],
                    self.at(n[0])
                ));
            }
            let mut lines = String::new();
            for from in (n[0]..n[1]).step_by(n[2] as usize) {
                let mut hash = Hash::default();
                (from..n[1].min(from + n[2])).for_each(|i| hash.add(self.at(i)));
                lines += &format!("{law} f32 {stream} {from} {:016x}\n", hash.value());
            }
            Ok(lines)
        }
    }

    #[test]
    fn every_wrong_result_is_found() {
        for wrong in [262_144, 262_145, 777_777, 1_048_575] {
            let line = "Ball f32 samples 1048576 0000000000000000";
            let (host, other) = (Fake { wrong: None }, Fake { wrong: Some(wrong) });
            let text = cause(&host, &other, "Ball", Stream::Samples, line).unwrap();
            let bits = u64::from(wrong) << 1;
            assert_eq!(
                text,
                format!(
                    "of       Ball f32 samples {wrong} x = 0x7\n\
                     expected Ball f32 samples {wrong} pdf(x) = {bits:#x}\n   \
                     found Ball f32 samples {wrong} pdf(x) = {:#x}\n",
                    bits | 1
                )
            );
        }
    }

    #[test]
    fn no_difference_is_said_to_be_none() {
        let line = "Ball f32 samples 64 0000000000000000";
        let fake = Fake { wrong: None };
        let text = cause(&fake, &fake, "Ball", Stream::Samples, line).unwrap();
        assert!(text.contains("value-breaking"));
    }
}
