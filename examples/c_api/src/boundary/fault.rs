//! The power-on self-test, and its fault as C reads it.

use super::{FAULT, Generator, NULL_POINTER, OK, words};
use core::ffi::c_int;
use coslobe::self_test::{self, Alarm, Fault, Score, Statistic, Subject, Test};

/// `coslobe_fault` of the header.
#[repr(C)]
#[derive(Default)]
pub struct CFault {
    kind: u32,
    sample: u32,
    period: u32,
    statistic: u32,
    tenths: u32,
    least: u32,
    most: u32,
    worst: u32,
}

impl From<Fault> for CFault {
    fn from(fault: Fault) -> Self {
        let of = |kind, score: Score| CFault {
            kind,
            statistic: match score.statistic {
                Statistic::Bits => 1,
                Statistic::Flips => 2,
                Statistic::Azimuth => 3,
                Statistic::Eighths => 4,
                Statistic::Polar => 5,
                Statistic::PolarAzimuth => 6,
                Statistic::PolarPairs => 7,
                Statistic::AzimuthPairs => 8,
                _ => 0,
            },
            tenths: score.tenths,
            least: score.least,
            most: score.most,
            worst: score.worst.into(),
            ..CFault::default()
        };
        match fault {
            Fault::Invalid { sample, .. } => CFault {
                kind: 1,
                sample: sample.into(),
                ..CFault::default()
            },
            Fault::Repeats { sample, period } => CFault {
                kind: 2,
                sample: sample.into(),
                period: period.into(),
                ..CFault::default()
            },
            Fault::TooUneven(score) => of(3, score),
            Fault::TooEven(score) => of(4, score),
            _ => CFault::default(),
        }
    }
}

/// The power-on check of a generator and a sampler; a fault is written unless `fault` is null.
///
/// # Safety
/// As in the head of the module [`boundary`](super).
pub(crate) unsafe fn judge<S: Subject>(
    rng: *const Generator,
    fault: *mut CFault,
    mut test: Test<S>,
) -> c_int {
    // SAFETY: the caller's promise.
    let Some(mut words) = (unsafe { words(rng) }) else {
        return NULL_POINTER;
    };
    test.run(&mut words, self_test::SAMPLES);
    if words.failure != OK {
        return words.failure;
    }
    let Err(found) = test.verdict(Alarm::OneInBillion) else {
        return OK;
    };
    // SAFETY: null or valid for a write.
    if let Some(fault) = unsafe { fault.as_mut() } {
        *fault = found.into();
    }
    FAULT
}
