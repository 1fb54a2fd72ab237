//! The one door to the error measurements of `tests/accuracy`: each operation's worst error.

use crate::accuracy::format::{Format, Subject};
use crate::accuracy::inputs::sample;
use crate::accuracy::measure::{OPERATIONS, Tally, Worst, at_angle, at_tail, sweep};
use crate::accuracy::reference::Id;
use crate::catalog::EXPONENT;
use crate::contender::law_name;
use crate::row::Error;

/// Worst errors of one operation of one law in one number type.
pub(crate) struct Judged {
    pub(crate) name: String,
    pub(crate) law: String,
    pub(crate) operation: String,
    pub(crate) error: Error,
}

/// How many inputs will be visited.
pub(crate) fn work(stride: u64, samples: u64) -> u64 {
    (f32::TOP_ANGLE + f32::HALF_BITS) / stride + 2 * (samples / 10) + 4 * samples
}

/// All operations: the fixed laws in f32 over every `stride`-th number, all else over `samples`.
pub(crate) fn measure(stride: u64, samples: u64, step: impl Fn(u64) + Sync) -> Vec<Judged> {
    let mut judged = Vec::new();
    let subjects = Subject::<f32>::all(&Id::FIXED);
    let tally = sweep(&subjects, f32::TOP_ANGLE, stride, at_angle, &step).merge(sweep(
        &subjects,
        f32::HALF_BITS,
        stride,
        at_tail,
        &step,
    ));
    collect(&mut judged, &subjects, &tally, stride == 1);
    let power = [Id::CosPower(EXPONENT)];
    sampled::<f32>(&mut judged, &power, samples / 10, &step);
    sampled::<f64>(&mut judged, &Id::FIXED, samples, &step);
    sampled::<f64>(&mut judged, &power, samples, &step);
    judged
}

fn sampled<T: Format>(judged: &mut Vec<Judged>, ids: &[Id], n: u64, step: impl Fn(u64) + Sync) {
    let subjects = Subject::<T>::all(ids);
    let tally = sample(&subjects, T::TOP_ANGLE, n, at_angle, &step).merge(sample(
        &subjects,
        T::HALF_BITS,
        n,
        at_tail,
        &step,
    ));
    collect(judged, &subjects, &tally, false);
}

fn collect<T: Format>(out: &mut Vec<Judged>, all: &[Subject<T>], tally: &Tally, exhaustive: bool) {
    for (subject, row) in all.iter().zip(&tally.0) {
        for ((_, name), worst) in OPERATIONS.iter().zip(row) {
            if worst.tried == 0 {
                continue;
            }
            // `warp: cos` and `warp: sin` are one call: the worse of the two is its error.
            let operation = name.split(':').next().unwrap_or(name);
            let law = law_name(subject.id);
            let error = error::<T>(worst, exhaustive);
            match out.last_mut() {
                Some(last) if last.operation == operation && last.law == law => {
                    last.error = last.error.clone().worse(error);
                }
                _ => out.push(Judged {
                    name: T::NAME.to_owned(),
                    law,
                    operation: operation.to_owned(),
                    error,
                }),
            }
        }
    }
}

fn error<T: Format>(worst: &Worst, exhaustive: bool) -> Error {
    Error {
        max_ulp: Some(worst.ulps),
        inputs: Some(worst.tried),
        exhaustive: Some(exhaustive),
        worst_input: Some(format!("{:#x}", worst.input)),
        correctly_rounded_percent: Some(100.0 * worst.correct as f64 / worst.tried as f64),
        misrounded: Some(worst.tried - worst.correct),
        max_relative: None,
        max_relative_tail: None,
    }
}
