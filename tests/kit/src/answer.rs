//! A line of words in, lines of text out.

use crate::laws::{Laws, Visitor};
use crate::stream::Walk;
use crate::{CHECKPOINTS, Hash, Sink, Stream, Subject};
use core::fmt::{self, Write};

/// How a request ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// All lines are written.
    Done,
    /// The request was not understood: what was expected is written.
    NotUnderstood,
}

const USAGE: &str = "expected LAW|all samples|values TASK, where TASK is\n\
    checkpoints LAST: hashes at the checkpoints up to LAST\n\
    blocks FROM TO STEP: hashes of each STEP results\n\
    results INDEX: what was hashed there, one a line";

#[derive(Clone, Copy)]
enum Task {
    Checkpoints { last: u32 },
    Blocks { from: u32, to: u32, step: u32 },
    Results { index: u32 },
}

/// Does what `words` ask for, for the laws in `T`.
///
/// # Errors
/// If `out` cannot be written to.
pub fn answer<'a, T: Laws>(
    mut words: impl Iterator<Item = &'a str>,
    out: &mut impl Write,
) -> Result<Answer, fmt::Error> {
    let law = words.next().unwrap_or_default();
    let stream = Stream::named(words.next().unwrap_or_default());
    let (Some(stream), Some(task)) = (stream, Task::parse(words)) else {
        writeln!(out, "{USAGE}")?;
        return Ok(Answer::NotUnderstood);
    };
    let mut visitor = Lines {
        law,
        stream,
        task,
        out,
        failed: Ok(()),
    };
    T::each(&mut visitor);
    visitor.failed.map(|()| Answer::Done)
}

impl Task {
    fn parse<'a>(mut words: impl Iterator<Item = &'a str>) -> Option<Self> {
        let name = words.next()?;
        let mut number = || words.next()?.parse().ok();
        let task = match name {
            "checkpoints" => Task::Checkpoints { last: number()? },
            "blocks" => Task::Blocks {
                from: number()?,
                to: number()?,
                step: number()?.max(1),
            },
            "results" => Task::Results { index: number()? },
            _ => return None,
        };
        words.next().is_none().then_some(task)
    }
}

struct Lines<'a, W> {
    law: &'a str,
    stream: Stream,
    task: Task,
    out: &'a mut W,
    failed: fmt::Result,
}

impl<W: Write> Visitor for Lines<'_, W> {
    fn visit<S: Subject>(&mut self, subject: &S) {
        if self.failed.is_ok() {
            self.failed = self.write(subject);
        }
    }
}

impl<W: Write> Lines<'_, W> {
    fn write<S: Subject>(&mut self, subject: &S) -> fmt::Result {
        if self.law != "all" && self.law != S::LAW {
            return Ok(());
        }
        let mut walk = Walk::new(subject, self.stream);
        let mut line = Line {
            start: (S::LAW, S::NUMBER, self.stream),
            index: 0,
            out: self.out,
            failed: Ok(()),
        };
        match self.task {
            Task::Checkpoints { last } => {
                let mut hash = Hash::default();
                let last = last.min(self.stream.length());
                for count in CHECKPOINTS.into_iter().filter(|&count| count <= last) {
                    walk.walk_to(count, &mut hash);
                    line.index = count;
                    line.hash(hash)?;
                }
                Ok(())
            }
            Task::Blocks { from, to, step } => {
                walk.skip_to(from);
                let mut at = from;
                while at < to {
                    let mut hash = Hash::default();
                    line.index = at;
                    at = at.saturating_add(step).min(to);
                    walk.walk_to(at, &mut hash);
                    line.hash(hash)?;
                }
                Ok(())
            }
            Task::Results { index } => {
                walk.skip_to(index);
                line.index = index;
                walk.walk_to(index.saturating_add(1), &mut line);
                line.failed
            }
        }
    }
}

/// Writes lines that begin with law, number type, stream and index.
struct Line<'a, W> {
    start: (&'static str, &'static str, Stream),
    index: u32,
    out: &'a mut W,
    failed: fmt::Result,
}

impl<W: Write> Line<'_, W> {
    fn hash(&mut self, hash: Hash) -> fmt::Result {
        let (law, number, stream) = self.start;
        let hash = hash.value();
        writeln!(
            self.out,
            "{law} {number} {stream} {} {hash:016x}",
            self.index
        )
    }
}

impl<W: Write> Sink for Line<'_, W> {
    const NAMES_INPUTS: bool = true;

    fn take(&mut self, operation: &'static str, bits: u64) {
        let (law, number, stream) = self.start;
        if self.failed.is_ok() {
            let index = self.index;
            self.failed = writeln!(
                self.out,
                "{law} {number} {stream} {index} {operation} = {bits:#x}"
            );
        }
    }
}
