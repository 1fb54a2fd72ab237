//! What is hashed of a subject, in order.

use crate::{Sink, Subject};
use core::fmt;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// A sequence of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stream {
    /// Successive samples from one generator.
    Samples,
    /// Every operation on successive inputs.
    Values,
}

/// Counts of samples or inputs after which the hash is reported.
pub const CHECKPOINTS: [u32; 8] = [
    1 << 6,
    1 << 8,
    1 << 10,
    1 << 12,
    1 << 14,
    1 << 16,
    1 << 18,
    1 << 20,
];

impl Stream {
    /// All streams.
    pub const ALL: [Stream; 2] = [Stream::Samples, Stream::Values];

    /// Where the stream ends: over 10⁶ samples; 16 384 inputs, of 16 results each at least.
    pub const fn length(self) -> u32 {
        match self {
            Stream::Samples => 1 << 20,
            Stream::Values => 1 << 14,
        }
    }

    /// The stream of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|s| s.name() == name)
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Stream::Samples => "samples",
            Stream::Values => "values",
        }
    }
}

impl fmt::Display for Stream {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A place in a subject's stream.
pub(crate) struct Walk<'a, S> {
    subject: &'a S,
    stream: Stream,
    index: u32,
    rng: Pcg32,
}

impl<'a, S: Subject> Walk<'a, S> {
    pub(crate) fn new(subject: &'a S, stream: Stream) -> Self {
        Walk {
            subject,
            stream,
            index: 0,
            rng: Pcg32::new(2024, 1),
        }
    }

    /// Passes by results up to `index`.
    pub(crate) fn skip_to(&mut self, index: u32) {
        match self.stream {
            Stream::Samples => self.walk_to(index, &mut Nothing),
            Stream::Values => self.index = index,
        }
    }

    /// Gives the sink all results up to `index`.
    pub(crate) fn walk_to(&mut self, index: u32, sink: &mut impl Sink) {
        while self.index < index {
            self.step(sink);
            self.index += 1;
        }
    }

    #[cfg(feature = "planted")]
    fn step(&mut self, sink: &mut impl Sink) {
        self.result(&mut crate::planted::Planted::at(S::LAW, self.index, sink));
    }

    #[cfg(not(feature = "planted"))]
    fn step(&mut self, sink: &mut impl Sink) {
        self.result(sink);
    }

    fn result(&mut self, sink: &mut impl Sink) {
        match self.stream {
            Stream::Samples => self.sample(sink),
            Stream::Values => self.subject.evaluate(self.index, sink),
        }
    }

    fn sample<K: Sink>(&mut self, sink: &mut K) {
        if K::NAMES_INPUTS {
            let mut words = self.rng.clone();
            for _ in 0..6 {
                sink.take("word", u64::from(words.next_u32()));
            }
        }
        self.subject.sample(&mut self.rng, sink);
    }
}

struct Nothing;

impl Sink for Nothing {
    const NAMES_INPUTS: bool = false;

    fn take(&mut self, _: &'static str, _: u64) {}
}
