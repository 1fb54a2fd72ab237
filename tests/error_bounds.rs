//! Every operation against true values: sweeps against wider arithmetic, and planted errors.

mod accuracy;

use accuracy::bounds::allowed;
use accuracy::format::{Format, Subject};
use accuracy::inputs::{exponents, sample};
use accuracy::measure::{OPERATIONS, Tally, at_angle, at_tail, sweep};
use accuracy::monotone;
use accuracy::reference::{self, Direction, Id};
use accuracy::spoiled::Spoiled;
use coslobe::SphereShell;

fn report<T: Format>(subjects: &[Subject<T>], tally: &Tally) -> Vec<String> {
    let mut broken = Vec::new();
    for (s, row) in subjects.iter().zip(&tally.0) {
        for ((_, name), worst) in OPERATIONS.iter().zip(row) {
            if worst.tried == 0 {
                continue;
            }
            let limit = allowed(T::NAME, s.id, name).unwrap_or(0.0);
            if worst.ulps > limit {
                broken.push(format!(
                    "{} {:?} {name}: {:.3} ulp at {:#x}, {limit} allowed",
                    T::NAME,
                    s.id,
                    worst.ulps,
                    worst.input
                ));
            }
        }
    }
    broken
}

fn holds<T: Format>(subjects: &[Subject<T>], tally: &Tally) {
    let broken = report(subjects, tally);
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

fn swept<T: Format>(ids: &[Id], stride: u64) {
    let subjects = Subject::<T>::all(ids);
    let angles = sweep(&subjects, T::TOP_ANGLE, stride, at_angle, |_| ());
    holds(
        &subjects,
        &angles.merge(sweep(&subjects, T::HALF_BITS, stride, at_tail, |_| ())),
    );
}

fn sampled<T: Format>(ids: &[Id], n: u64) {
    let subjects = Subject::<T>::all(ids);
    let angles = sample(&subjects, T::TOP_ANGLE, n, at_angle, |_| ());
    holds(
        &subjects,
        &angles.merge(sample(&subjects, T::HALF_BITS, n, at_tail, |_| ())),
    );
}

#[test]
fn f32_strided() {
    swept::<f32>(&Id::FIXED, 1009);
}

#[test]
#[ignore = "opt-in, an hour: cargo test --release --test error_bounds -- --ignored"]
fn f32_exhaustive() {
    swept::<f32>(&Id::FIXED, 1);
}

#[test]
fn f64_stratified() {
    sampled::<f64>(&Id::FIXED, 1_000_002);
}

#[test]
fn real_exponents() {
    sampled::<f32>(&exponents::<f32>(), 100_002);
    sampled::<f64>(&exponents::<f64>(), 60_000);
}

fn rejects<T: Format>(spoiled: Spoiled, stride: u64) {
    let subjects = [Subject::<T> {
        id: Id::Disk,
        law: Box::new(spoiled),
        solid: None,
    }];
    let tally = sweep(&subjects, T::TOP_ANGLE, stride, at_angle, |_| ());
    assert!(!report(&subjects, &tally).is_empty());
}

#[test]
fn planted_errors_are_caught() {
    for spoiled in [
        Spoiled::NaiveCosine,
        Spoiled::OneMinus,
        Spoiled::NaiveResidual,
        Spoiled::Nudged,
    ] {
        rejects::<f32>(spoiled, 1009);
    }
    rejects::<f64>(Spoiled::OneMinus, 1 << 40);
    rejects::<f64>(Spoiled::NaiveResidual, 1 << 40);
}

/// A law under another's name is caught too: the sphere's shell is not the sphere's area.
#[test]
fn a_wrong_exponent_is_caught() {
    let subjects = [Subject::<f32> {
        id: Id::Lambert,
        law: Box::new(SphereShell),
        solid: None,
    }];
    let tally = sweep(&subjects, f32::HALF_BITS, 100_003, at_tail, |_| ());
    assert!(!report(&subjects, &tally).is_empty());
}

fn never_steps_back(find: impl Fn(Id) -> (u64, u64)) {
    for id in Id::FIXED {
        let (bad, first) = find(id);
        assert_eq!(
            bad, 0,
            "{id:?}: quantile or isf steps back or does not mirror from {first:#x}"
        );
    }
}

/// The logarithm of a narrow lobe's density at the angles where the density passes 1.
fn crosses_zero<T: Format>() {
    for k in [1e3, 1e6, 1e30] {
        let subjects = [Subject::<T>::new(Id::CosPower(k))];
        let peak = 1.0 / (k + 1.0).sqrt();
        for (mut above, mut below) in [(peak, peak * 60.0), (peak, peak * 1e-12 / k)] {
            let value = |theta: f64| {
                let at = Direction::<f64>::at_angle(theta.min(1.57));
                reference::ln_pdf(Id::CosPower(k), &at)
            };
            assert!(
                value(above) > 0.0 && value(below) < 0.0,
                "{k:e} from {above:e} to {below:e}"
            );
            for _ in 0..200 {
                let middle = (above + below) / 2.0;
                if value(middle) > 0.0 {
                    above = middle
                } else {
                    below = middle
                }
            }
            let mut tally = Tally::new(1);
            for step in 0..400 {
                let theta = T::of_bits(T::round(below).bits() + step - 200);
                at_angle(&subjects, theta, &mut tally);
            }
            holds(&subjects, &tally);
        }
    }
}

#[test]
fn logarithms_that_cross_zero() {
    crosses_zero::<f32>();
    crosses_zero::<f64>();
}

#[test]
fn quantiles_are_monotone_and_odd() {
    never_steps_back(|id| monotone::strided(&Subject::<f32>::new(id), 101));
    never_steps_back(|id| monotone::sampled(&Subject::<f64>::new(id), 1_000_000));
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release --test error_bounds -- --ignored"]
fn f32_quantiles_are_monotone_everywhere() {
    never_steps_back(|id| monotone::strided(&Subject::<f32>::new(id), 1));
}
